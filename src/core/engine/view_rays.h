// SPDX-License-Identifier: BSD-3-Clause
// The rays of a view and the cells of the display that they meet. It reads no texels.
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
#include "core/optics/display.h"
#include "core/optics/simulate.h"

namespace hogelscope {

class ViewRays {
 public:
  /// `tables` keeps lens tables from view to view. `progress` is kept and asked wherever casting
  /// takes long, here and in all functions; it does not hear how much is done. Throws InputError as
  /// Simulation does, and Cancelled, as all functions that cast rays do.
  ViewRays(const View& view, LensTables& tables, const ParallelRows& parallelRows,
           const Progress& progress = {});

  [[nodiscard]] const View& view() const { return m_view; }
  [[nodiscard]] const Plan& plan() const { return m_plan; }
  [[nodiscard]] const Progress& progress() const { return m_progress; }
  /// Whether the eye is not in front of the panel.
  [[nodiscard]] bool seesNothing() const { return m_seesNothing; }
  /// From ideal points to cells, where the hogel lens is linear.
  [[nodiscard]] const HitMap& map() const { return m_map; }
  /// Null for a plain lens, and for a table that would be too large.
  [[nodiscard]] const LensTable* lens() const { return m_lens.get(); }
  [[nodiscard]] const LensKey& lensKey() const { return m_lensKey; }
  /// For a plain lens: ideal points of the columns from x0 on, and of a row.
  [[nodiscard]] const double* plainX(int x0) const { return &m_x[std::size_t(x0)]; }
  [[nodiscard]] double plainY(int y) const {
    return (y - m_lensKey.centre.y) / m_lensKey.focalLength.y;
  }

  /// How many rays the picture takes: all, or where the outline is known those that hit.
  [[nodiscard]] std::int64_t count() const;
  /// Where the outline is known: the columns [first, last) of [x0, x1) whose rays hit.
  [[nodiscard]] std::array<int, 2> seenPart(int y, int x0, int x1) const;

  /// What the rays of sub-pixel (sx, sy) of pixels [x0, x0 + count) of row y meet; at most a batch.
  /// May be called from several threads, as the next one.
  void cells(int y, int x0, int count, int sx, int sy, CellBatch& batch) const;
  /// The texels that pixels [x0, x1) of row y may read: their rays, interpolation and leakage.
  [[nodiscard]] Footprint footprint(int y, int x0, int x1) const;
  /// Those of the whole picture.
  [[nodiscard]] Footprint footprint(const ParallelRows& parallelRows) const;

 private:
  View m_view;
  Progress m_progress;  ///< for threads
  Display m_display;
  Plan m_plan;
  LensKey m_lensKey;
  HitMap m_map;
  bool m_seesNothing = false;
  std::shared_ptr<const LensTable> m_lens;
  std::optional<LensRays> m_rays;  ///< where they are not kept in a table
  std::vector<double> m_x;         ///< of each pixel column, plain lens
};

}  // namespace hogelscope
