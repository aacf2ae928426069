// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/colour_map.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

std::array<std::uint8_t, 3> falseColour(double share) {
  // Nine of viridis' colours; the scale is nearly linear between them.
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

const char* seriesColour(std::size_t series) {
  constexpr std::array<const char*, 7> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                               "#e69f00", "#56b4e9", "#000000"};
  return colours[series % colours.size()];
}

}  // namespace hogelscope
