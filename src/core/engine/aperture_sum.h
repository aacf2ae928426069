// SPDX-License-Identifier: BSD-3-Clause
// Sums the images from all points of an aperture, in linear light. The points share the lens' rays,
// since each batch of pixels is finished for all points before the next one, and the light of the
// texels that several of them meet.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "core/engine/aperture_kernels.h"
#include "core/engine/texel_filter.h"
#include "core/engine/view_rays.h"

namespace hogelscope {

class ApertureSum {
 public:
  /// Refers to its parameters, which must outlive this object.
  ApertureSum(const ViewRays& rays, const LightField& texels, const TexelFilter& filter);

  /// Writes the code values of pixels [x0, x1) of row y, unrounded, and their mask. Both must be 0
  /// before.
  void row(int y, int x0, int x1, float* rgb, std::uint8_t* seen) const;

 private:
  struct Scratch;

  void addBatch(int y, int x0, int count, Scratch& scratch) const;
  void addPoint(std::size_t point, int count, Scratch& scratch) const;
  [[nodiscard]] bool findSpreads(int count, Scratch& scratch) const;
  void addShared(int count, Scratch& scratch) const;
  [[nodiscard]] bool isInMemory(const std::array<int, 4>& cell) const;
  void addTexel(const std::array<int, 4>& cell, float points, std::size_t pixel,
                Scratch& scratch) const;
  void emptyQueue(Scratch& scratch) const;

  const ViewRays& m_rays;
  const LightField& m_texels;
  const TexelFilter& m_filter;
  ApertureOffsets m_offsets;
  double m_radius = 0;    ///< largest offset along the panel, metres
  double m_depth = 0;     ///< largest offset along its normal
  bool m_shares = false;  ///< points that meet the same texel share its light
  /// The texels, if they have 8 bits and the light from a point is one of them; otherwise null.
  const Texel<std::uint8_t>* m_bytes = nullptr;
};

}  // namespace hogelscope
