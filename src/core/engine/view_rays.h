// SPDX-License-Identifier: BSD-3-Clause
// The rays of a view and the cells of the display that they meet. It reads no texels: footprints,
// the error on the panel, --explain and streaming need nothing else.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/progress.h"
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

class ViewRays {
 public:
  /// `tables` keeps lens tables between views. `progress` is kept and called wherever casting takes
  /// long, here and in all functions; it only cancels, without a fraction done. Throws InputError
  /// as Simulation does, and Cancelled, as all functions that cast rays do.
  ViewRays(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
           const Progress& progress = {});

  [[nodiscard]] const RenderJob& job() const { return m_job; }
  [[nodiscard]] const Plan& plan() const { return m_plan; }
  [[nodiscard]] const Progress& progress() const { return m_progress; }
  /// Whether the eye is not in front of the panel.
  [[nodiscard]] bool seesNothing() const { return m_plan.isBehind; }
  /// Returns the eye in the display frame, metres.
  [[nodiscard]] const Vec3& eye() const { return m_eye; }
  /// Returns the rays of a pixel.
  [[nodiscard]] const std::vector<RaySample>& samples() const { return m_samples; }
  /// Returns the map from ideal points to cells.
  [[nodiscard]] const HitMap& map() const { return m_map; }
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
  /// Returns the columns [first, last) of [x0, x1) whose rays hit, if the outline is known.
  [[nodiscard]] std::array<int, 2> seenPart(int y, int x0, int x1) const;

  /// Finds the cells that one ray of each of the pixels [x0, x0 + count) of row y meets; at most a
  /// batch. Thread-safe, as lines() is.
  void cells(int y, int x0, int count, const RaySample& sample, CellBatch& batch) const;
  /// Finds the slopes dx/dz, dy/dz in the display frame of the same rays.
  void lines(int y, int x0, int count, const RaySample& sample, LineBatch& batch) const;
  /// Returns the texels that pixels [x0, x1) of row y may read, interpolation and leakage included.
  [[nodiscard]] Footprint footprint(int y, int x0, int x1) const;
  /// Returns the texels that the whole image may read.
  [[nodiscard]] Footprint footprint(const ParallelRows& parallelRows) const;
  /// Returns the view's reads, whose functions refer to this object.
  [[nodiscard]] ViewReads reads(const ParallelRows& parallelRows) const;

 private:
  /// The points of the plane z = 1 of a batch, in madeX and madeY or elsewhere.
  struct Points {
    std::array<double, batchSize> madeX;
    std::array<double, batchSize> madeY;
    const double* x = nullptr;
    const double* y = nullptr;
  };
  void points(int y, int x0, int count, const RaySample& sample, Points& points) const;
  void cellsOf(const Points& points, int count, CellBatch& batch) const;
  void addFootprint(int y, int x0, int x1, Footprint& footprint) const;
  [[nodiscard]] bool isSeparable() const;
  [[nodiscard]] Footprint separableFootprint() const;
  void mark(int y, const SliceLayout& layout, std::vector<std::uint8_t>& marks) const;

  RenderJob m_job;
  Progress m_progress;  ///< for threads
  Display m_display;
  std::vector<RaySample> m_samples;
  Plan m_plan;
  LensKey m_lensKey;
  HitMap m_map;
  Vec3 m_eye;
  std::shared_ptr<const LensTable> m_lens;
  std::optional<LensRays> m_rays;  ///< if they are not kept in a table
  std::vector<double> m_x;         ///< ideal x of each pixel column, plain lens
};

}  // namespace hogelscope
