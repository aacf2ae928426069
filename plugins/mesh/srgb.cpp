// SPDX-License-Identifier: BSD-3-Clause
#include "srgb.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hogelscope::mesh {

namespace {

constexpr std::size_t steps = 4096;

std::array<float, steps + 2> makeCodes() {
  std::array<float, steps + 2> codes{};
  for (std::size_t k = 0; k < codes.size(); ++k) {
    const double x = std::min(double(k) / steps, 1.0);
    codes[k] = float(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055));
  }
  return codes;
}

}  // namespace

double linearOf(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

float codeOf(float linear) {
  static const auto codes = makeCodes();
  const float x = std::clamp(linear, 0.0F, 1.0F) * steps;
  const auto k = std::size_t(x);
  return codes[k] + (x - float(k)) * (codes[k + 1] - codes[k]);
}

}  // namespace hogelscope::mesh
