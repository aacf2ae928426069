// SPDX-License-Identifier: BSD-3-Clause
// The fast engine: rows of rays in batches. Its pixels equal the reference's (simulate.h), except
// where a coordinate lies within 1e-4 of a cell border or a sum within 1e-3 of a rounding
// half.
#pragma once

#include <memory>
#include <optional>

#include "core/engine/lens_kernels.h"
#include "core/engine/texel_filter.h"
#include "core/engine/view_rays.h"
#include "core/optics/image.h"

namespace hogelscope {

class FastSimulation {
 public:
  /// Fetches the texels; casts the view's rays first if the light field needs to know the texels
  /// that they read. The parameters and exceptions are those of ViewRays and
  /// LightFieldSource::slice().
  FastSimulation(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                 const Progress& progress = {});

  [[nodiscard]] const ViewRays& rays() const { return m_rays; }

  /// Renders pixels [x0, x1) of rows [y0, y1), row by row without a gap: three 8-bit values each,
  /// and 255 or 0 for seen or not. Rows that are rendered together take less time: the texels of
  /// one come from memory while those of the row before are copied. May be called from several
  /// threads. Throws Cancelled.
  void rows(int y0, int y1, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const;
  /// Renders the same in code values, unrounded.
  void rows(int y0, int y1, int x0, int x1, float* rgb, std::uint8_t* seen) const;

 private:
  struct Scratch;

  void copyRows(int y0, int y1, int x0, int x1, std::uint8_t* rgb, std::uint8_t* seen) const;
  void sumRow(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const;

  ViewRays m_rays;
  std::shared_ptr<const LightField> m_texels;
  TexelFilter m_filter;
  bool m_copies;                       ///< pixels are texels, or sub-pixels
  std::optional<FixedMap> m_fixedMap;  ///< of a lens whose texels are copied
};

}  // namespace hogelscope
