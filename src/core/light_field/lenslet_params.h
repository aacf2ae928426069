// SPDX-License-Identifier: BSD-3-Clause
// The parameters of an image taken through an array of lenslets.
#pragma once

#include <array>
#include <string>

#include "core/base/parameters.h"

namespace hogelscope {

enum class LensletGrid { square, hexagonal };

/// Values that are not given are found in the white image (docs/formulas.md, Lenslets).
struct LensletParams {
  std::string white;  ///< an image of even light; "" = the light field itself
  std::string dark;   ///< an image without light; "" = none
  LensletGrid grid = LensletGrid::square;
  double pitch = notGiven;     ///< pixels between neighbours in a row
  double rotation = notGiven;  ///< degrees, of a row; clockwise in the image is positive
  /// x and y of the first lenslet's middle; the middle of the top left pixel is (0, 0).
  std::array<double, 2> origin{notGiven, notGiven};
  double gain = 1;  ///< factor of the light, for images that use few of their bits
  [[nodiscard]] bool isOriginGiven() const {
    return origin[0] != notGiven && origin[1] != notGiven;
  }
  bool operator==(const LensletParams&) const = default;
};

}  // namespace hogelscope
