// SPDX-License-Identifier: BSD-3-Clause
// Colours of plots, images and the 3-D scene: one scale, and one list for series.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hogelscope {

/// Returns a colour of matplotlib's viridis (CC0) from dark violet (0) to yellow (1), clamped; grey
/// for NaN. Its lightness is even, so that it is also readable in greyscale.
std::array<std::uint8_t, 3> falseColour(double share);

/// Returns "#rrggbb" for the k-th of several series; colours repeat after seven. They are those of
/// Okabe and Ito, for all kinds of colour vision, without the yellow, which is hard to see on
/// paper.
const char* seriesColour(std::size_t series);

}  // namespace hogelscope
