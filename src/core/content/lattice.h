// SPDX-License-Identifier: BSD-3-Clause
// The points over which a directional pixel's light is averaged (docs/formulas.md, Live scenes).
#pragma once

#include <array>
#include <cstddef>

namespace hogelscope {

/// Returns point k of n of the rank-1 lattice along an axis, -1/2 … 1/2; the middle for n = 1.
inline double latticeOffset(int k, int n, std::size_t axis) {
  constexpr std::array<int, 4> generator{1, 3, 5, 7};
  return n == 1 ? 0 : (k * generator[axis] % n + 0.5) / n - 0.5;
}

}  // namespace hogelscope
