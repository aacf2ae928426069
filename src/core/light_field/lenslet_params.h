// SPDX-License-Identifier: BSD-3-Clause
// What a picture taken through an array of lenslets does not say about itself.
#pragma once

#include <array>
#include <string>

#include "core/base/parameters.h"

namespace hogelscope {

enum class LensletGrid { square, hexagonal };

/// What is not given is found in the white picture (docs/formulas.md, Lenslets).
struct LensletParams {
  std::string white;  ///< a picture of even light; "" = the light field itself
  std::string dark;   ///< a picture without light; "" = none
  LensletGrid grid = LensletGrid::square;
  double pitch = notGiven;     ///< pixels between neighbours in a row
  double rotation = notGiven;  ///< degrees, of a row; clockwise in the picture is positive
  /// x and y of the first lenslet's middle; the middle of the top left pixel is (0, 0).
  std::array<double, 2> origin{notGiven, notGiven};
  double gain = 1;  ///< of the light, for pictures that use few of their bits
  [[nodiscard]] bool isOriginGiven() const {
    return origin[0] != notGiven && origin[1] != notGiven;
  }
  bool operator==(const LensletParams&) const = default;
};

}  // namespace hogelscope
