// SPDX-License-Identifier: BSD-3-Clause
// Colours of plots, images and the 3-D scene: one scale, and one list for series.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hogelscope {

/// matplotlib's viridis (CC0), even in lightness, so that it also reads in grey.
/// Returns a colour from dark violet (0) to yellow (1); clamps beyond them; grey for NaN.
std::array<std::uint8_t, 3> falseColour(double share);

/// Returns "#rrggbb" for the k-th of several series; it is repeated after seven. Okabe and Ito's
/// colours for all kinds of colour vision, without the yellow, which paper loses.
const char* seriesColour(std::size_t series);

}  // namespace hogelscope
