// SPDX-License-Identifier: BSD-3-Clause
// The light under lenslets: removes dark frame and vignetting from images, and samples the
// directions of hogels (docs/formulas.md, Lenslets).
#pragma once

#include <array>
#include <vector>

#include "capture/lenslets/lenslet_search.h"

namespace hogelscope {

/// The values of an image, where 1 is full scale: one or three per pixel, in rows from the top.
struct LensletLight {
  int width = 0;
  int height = 0;
  std::size_t channels = 1;
  std::vector<float> values;
};

/// Subtracts a dark frame, if there is one; values below 0 become 0.
void subtract(LensletPlane& plane, const LensletPlane& dark);

/// Divides an image of even light by its mean over the lenslets' middles. Throws InputError
/// without a file name if they are black.
void normalise(LensletPlane& white, const LensletLattice& lattice, const LightFieldSize& size);

/// The least white value that light is divided by; less would only amplify noise.
inline constexpr float leastWhite = 0.2F;

/// Samples the directions of hogels.
class LensletSampler {
 public:
  /// Makes directions black that are dark in the white image.
  LensletSampler(LensletLight light, const LensletPlane& white, const LensletLattice& lattice,
                 const LightFieldSize& size);

  /// Sets red, green and blue; 1 is full scale.
  void sample(const TexelIndex& at, std::array<double, 3>& rgb) const;

 private:
  [[nodiscard]] bool isOwn(const PicturePoint& offset) const;
  void darken(const LensletPlane& white);
  void add(const PicturePoint& at, double weight, std::array<double, 3>& rgb) const;

  LensletLight m_light;
  LensletLattice m_lattice;
  LightFieldSize m_size;
  std::vector<PicturePoint> m_offsets;  ///< of each direction from a lenslet's middle
  std::vector<bool> m_isLit;            ///< for each direction
};

}  // namespace hogelscope
