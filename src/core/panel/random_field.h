// SPDX-License-Identifier: BSD-3-Clause
// Normal draws for the cells of a grid that depend on nothing but the seed and the cell, so that a
// part of a grid drawn alone has the same numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"

namespace hogelscope {

/// Cells [i, i + width) × [j, j + height) of a grid without borders.
struct GridPart {
  int i = 0;
  int j = 0;
  int width = 0;
  int height = 0;
};

/// Returns a draw of mean 0 and variance 1 for cell (i, j); `what` tells draws of one seed apart.
double normalAt(std::uint32_t seed, std::uint32_t what, int i, int j);

/// Returns draws row by row, of mean 0 and variance 1, whose correlation at the distance d is
/// exp(−d²/length²), both in cells, from a length of about 1.5 on: independent ones filtered by a
/// Gaussian of s = length/2, divided by √Σw². `length` 0: independent. Throws Cancelled.
std::vector<float> randomField(std::uint32_t seed, std::uint32_t what, double length,
                               const GridPart& part, const Progress& progress = {});

}  // namespace hogelscope
