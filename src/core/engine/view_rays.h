// SPDX-License-Identifier: BSD-3-Clause
// The rays of a view and the cells of the display that they meet. It reads no texels: footprints,
// the error on the panel, --explain and streaming need nothing else.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/engine/outline.h"
#include "core/engine/plan.h"
#include "core/engine/row_kernels.h"
#include "core/lens/lens_table.h"
#include "core/light_field/footprint.h"
#include "core/optics/simulate.h"
#include "core/panel/display.h"

namespace hogelscope {

/// Pixels [x0, x1) of row y.
struct PixelRun {
  int y = 0;
  int x0 = 0;
  int x1 = 0;
  bool operator==(const PixelRun&) const = default;
};

/// The rays of a batch as lines; only those that see the display have slopes.
struct LineBatch {
  std::array<Vec2, batchSize> slopes;
  std::array<std::uint8_t, batchSize> seen;
};

/// The ideal points of a batch, of the plane z = 1, in madeX and madeY or elsewhere.
struct IdealBatch {
  std::array<double, batchSize> madeX;
  std::array<double, batchSize> madeY;
  const double* x = nullptr;
  const double* y = nullptr;
};

/// The middle of an aperture, which is the eye.
struct ApertureMiddle {
  HitMap map;                        ///< as from a point there
  Vec3 eye;                          ///< in the display frame, metres
  std::array<double, 4> perMetre{};  ///< what the map's constants grow by as the eye moves
};

class ViewRays {
 public:
  /// `tables` keeps lens tables between views. `progress` is kept and called wherever casting takes
  /// long, here and in all functions; it only cancels, without a fraction done. Throws InputError
  /// as Simulation does, and Cancelled, as all functions that cast rays do.
  ViewRays(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
           const Progress& progress = {});
  ViewRays(const ViewRays&) = delete;  // the maps refer to its display
  ViewRays& operator=(const ViewRays&) = delete;

  [[nodiscard]] const RenderJob& job() const { return m_job; }
  [[nodiscard]] const Plan& plan() const { return m_plan; }
  [[nodiscard]] const Progress& progress() const { return m_progress; }
  /// Whether no point of the aperture is in front of the panel.
  [[nodiscard]] bool seesNothing() const { return m_plan.isBehind; }
  /// Whether a point of the aperture is in front of the panel. From others nothing is seen, and no
  /// kernel is asked, since its arithmetic is for eyes in front.
  [[nodiscard]] bool isInFront(std::size_t point) const { return m_eyes[point].z > 0; }
  /// Returns a point of the aperture in the display frame, metres; the eye, for a pinhole.
  [[nodiscard]] const Vec3& eye(std::size_t point) const { return m_eyes[point]; }
  /// Returns the number of points of the aperture: 1 for a pinhole.
  [[nodiscard]] std::size_t points() const { return m_maps.size(); }
  /// Returns the rays of a pixel from one point of the aperture.
  [[nodiscard]] std::span<const RaySample> samplesFrom(std::size_t point) const {
    const std::size_t each = m_samples.size() / points();
    return std::span(m_samples).subspan(point * each, each);
  }
  /// Returns the middle of the aperture, for a view that is not a pinhole's.
  [[nodiscard]] const ApertureMiddle& middle() const { return m_middle; }
  /// Returns the map from ideal points to cells, from a point of the aperture.
  [[nodiscard]] const HitMap& map(std::size_t point) const { return m_maps[point]; }
  /// Returns the lens table; null for a plain lens, or if it would be too large.
  [[nodiscard]] const LensTable* lens() const { return m_lens.get(); }
  [[nodiscard]] const LensKey& lensKey() const { return m_lensKey; }
  /// Return the ideal x of the columns from x0 on, and the ideal y of a row, for a plain lens.
  [[nodiscard]] const double* plainX(int x0) const { return &m_x[std::size_t(x0)]; }
  [[nodiscard]] double plainY(int y) const {
    return (y - m_lensKey.centre.y) / m_lensKey.focalLength.y;
  }

  /// Returns the number of rays of the image: all, or those that hit if the outline is known.
  [[nodiscard]] std::int64_t count() const;
  /// Returns four columns of [x0, x1), ascending: no ray before the first and from the last on
  /// hits, all between the middle two do. These are the outer two if the plan knows the outline.
  [[nodiscard]] std::array<int, 4> seenParts(int y, int x0, int x1) const;

  /// Finds the cells that one ray of each of the pixels [x0, x0 + count) of row y meets; at most a
  /// batch. Thread-safe, as lines() is.
  void cells(int y, int x0, int count, const RaySample& sample, CellBatch& batch) const;
  /// Finds the ideal points of the same rays, which the point of the aperture does not change.
  void ideals(int y, int x0, int count, const RaySample& sample, IdealBatch& batch) const;
  /// Finds the cells that the rays through them meet from a point of the aperture.
  void cellsOf(const IdealBatch& ideals, int count, std::size_t point, CellBatch& batch,
               std::size_t channel = greenChannel) const;
  /// Finds the slopes dx/dz, dy/dz in the display frame of the same rays.
  void lines(int y, int x0, int count, const RaySample& sample, LineBatch& batch) const;
  /// Returns the texels that pixels [x0, x1) of row y may read, interpolation and leakage included.
  [[nodiscard]] Footprint footprint(int y, int x0, int x1) const;
  /// Returns the texels that the whole image may read.
  [[nodiscard]] Footprint footprint(const ParallelRows& parallelRows) const;
  /// Returns the view's reads, whose functions refer to this object.
  [[nodiscard]] ViewReads reads(const ParallelRows& parallelRows) const;

 private:
  template <class Use>
  void eachBatch(int y, int x0, int x1, const Use& use) const;
  void addFootprint(int y, int x0, int x1, Footprint& footprint) const;
  /// The distance to a cell's border, in cells, at which the points of an aperture, whose cells are
  /// found in float arithmetic, may meet the next cell.
  [[nodiscard]] float border() const { return points() > 1 ? 4e-5F : 0; }
  [[nodiscard]] bool isSeparable() const;
  [[nodiscard]] Footprint separableFootprint() const;
  void mark(int y, const SliceLayout& layout, std::vector<std::uint8_t>& marks) const;

  RenderJob m_job;
  Progress m_progress;  ///< for threads
  Display m_display;
  std::vector<RaySample> m_samples;
  Plan m_plan;
  LensKey m_lensKey;
  std::vector<HitMap> m_maps;  ///< for each point of the aperture
  std::vector<Vec3> m_eyes;    ///< the same
  ApertureMiddle m_middle;
  std::optional<Outline> m_outline;  ///< if it is known, and columns are places on the image plane
  std::shared_ptr<const LensTable> m_lens;
  std::optional<LensRays> m_rays;  ///< if they are not kept in a table
  std::vector<double> m_x;         ///< ideal x of each pixel column, plain lens
};

}  // namespace hogelscope
