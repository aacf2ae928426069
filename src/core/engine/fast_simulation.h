// SPDX-License-Identifier: BSD-3-Clause
// The fast engine: rows of rays in batches. The same pixels as the reference (core/simulate.h),
// except where a coordinate lies within 1e-4 of a cell border or a sum within 1e-3 of a rounding
// half.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/engine/plan.h"
#include "core/engine/row_kernels.h"
#include "core/engine/texel_filter.h"
#include "core/lens/lens_table.h"
#include "core/optics/display.h"
#include "core/optics/simulate.h"

namespace hogelscope {

class FastSimulation {
 public:
  /// `tables` keeps lens tables from view to view. What the view needs of a light field in a store
  /// is fetched. `progress` is kept and asked wherever a picture takes long, here and in what
  /// follows, whose done fraction it does not hear. Throws InputError, as Simulation does, or
  /// Cancelled, as all that casts rays does.
  FastSimulation(const View& view, LensTables& tables, const ParallelRows& parallelRows,
                 const Progress& progress = {});

  [[nodiscard]] const Plan& plan() const { return m_plan; }
  /// Null for a plain lens.
  [[nodiscard]] const LensTable* lens() const { return m_lens.get(); }
  /// How many rays the picture takes: all, or where the outline is known those that hit.
  [[nodiscard]] std::int64_t rays() const;

  /// Pixels [x0, x1) of row y: three 8-bit values each, and 255 or 0 whether they are seen. May be
  /// called from several threads.
  void row(int y, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const;
  /// The same in code values, unrounded.
  void row(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const;

  /// What the rays of sub-pixel (sx, sy) of pixels [x0, x0 + count) of row y meet; at most a batch.
  void cells(int y, int x0, int count, int sx, int sy, CellBatch& batch) const;

 private:
  struct Scratch;

  void fetch(const ParallelRows& parallelRows);
  void copyRow(int y, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const;
  void copyPlainRow(int y, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const;
  void sumRow(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const;
  [[nodiscard]] bool castRays(int y, int x0, int count, int sx, int sy, Scratch& scratch) const;
  [[nodiscard]] std::array<int, 2> seenPart(int y, int x0, int x1) const;

  View m_view;
  Progress m_progress;  ///< for threads
  Plan m_plan;
  std::shared_ptr<const LensTable> m_lens;
  HitMap m_map;
  bool m_seesNothing = false;
  std::uint32_t m_unseen = 0;  ///< address of the black texel
  std::vector<double> m_x;     ///< of each pixel column, plain lens
  LensKey m_lensKey;
  std::optional<LensRays> m_rays;  ///< where rays are not kept in a table
  std::optional<TexelFilter> m_taps;
};

/// The whole picture by the fast engine. `progress` hears of rows, from all threads; it may say
/// stop. Throws InputError, Cancelled.
Image simulateFast(const View& view, LensTables& tables,
                   const ParallelRows& parallelRows = serialRows, const Progress& progress = {});
/// On the calling thread.
Image simulateFast(const View& view);

}  // namespace hogelscope
