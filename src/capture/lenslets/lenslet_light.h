// SPDX-License-Identifier: BSD-3-Clause
// The light under lenslets: pictures without their dark frame and vignetting, and what a direction
// of a hogel is of them (docs/formulas.md, Lenslets).
#pragma once

#include <array>
#include <vector>

#include "capture/lenslets/lenslet_search.h"

namespace hogelscope {

/// A picture's values, of which 1 is full scale: one or three for a pixel, in rows from the top.
struct LensletLight {
  int width = 0;
  int height = 0;
  std::size_t channels = 1;
  std::vector<float> values;
};

/// Subtracts a dark frame, if there is one; nothing is darker than 0.
void subtract(LensletPlane& plane, const LensletPlane& dark);

/// Divides a picture of even light by its mean over the lenslets' middles. Throws InputError that
/// names no file: they are dark.
void normalise(LensletPlane& white, const LensletLattice& lattice, const LightFieldSize& size);

/// What of a pixel's light the white picture at least has: less would only show noise.
inline constexpr float leastWhite = 0.2F;

/// Samples the directions of hogels.
class LensletSampler {
 public:
  /// Directions that are dark in the white picture are black.
  LensletSampler(LensletLight light, const LensletPlane& white, const LensletLattice& lattice,
                 const LightFieldSize& size);

  /// Sets red, green and blue, of which 1 is full scale.
  void sample(const TexelIndex& at, std::array<double, 3>& rgb) const;

 private:
  [[nodiscard]] bool isOwn(const PicturePoint& offset) const;
  void darken(const LensletPlane& white);
  void add(const PicturePoint& at, double weight, std::array<double, 3>& rgb) const;

  LensletLight m_light;
  LensletLattice m_lattice;
  LightFieldSize m_size;
  std::vector<PicturePoint> m_offsets;  ///< of directions from the middle of a lenslet
  std::vector<bool> m_isLit;            ///< directions
};

}  // namespace hogelscope
