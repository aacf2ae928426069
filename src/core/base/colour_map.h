// SPDX-License-Identifier: BSD-3-Clause
// The one false-colour scale, in plots, images and the 3-D scene alike: matplotlib's viridis
// (CC0), even in lightness, so that it also reads in grey.
#pragma once

#include <array>
#include <cstdint>

namespace hogelscope {

/// Returns a colour from dark violet (0) to yellow (1); clamps beyond them; grey for NaN.
std::array<std::uint8_t, 3> falseColour(double share);

}  // namespace hogelscope
