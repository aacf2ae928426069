// SPDX-License-Identifier: BSD-3-Clause
// Viridis between nine of its colours.
#include "core/base/colour_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hogelscope {

std::array<std::uint8_t, 3> falseColour(double share) {
  constexpr std::array<std::array<double, 3>, 9> viridis{{{68, 1, 84},
                                                          {71, 44, 122},
                                                          {59, 81, 139},
                                                          {44, 113, 142},
                                                          {33, 144, 141},
                                                          {39, 173, 129},
                                                          {92, 200, 99},
                                                          {170, 220, 50},
                                                          {253, 231, 37}}};
  if (std::isnan(share)) return {128, 128, 128};
  const double place = std::clamp(share, 0.0, 1.0) * double(viridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
  const double part = place - double(below);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t k = 0; k < 3; ++k)
    colour[k] = static_cast<std::uint8_t>(
        std::lround((1 - part) * viridis[below][k] + part * viridis[below + 1][k]));
  return colour;
}

}  // namespace hogelscope
