// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/psnr_scale.h"

#include <algorithm>
#include <cmath>

#include "core/base/colour_map.h"

namespace hogelscope {

namespace {

/// Returns the range of the finite values, at least 1 dB wide so that equal values have a scale
/// too.
std::array<double, 2> rangeOf(const std::vector<double>& values) {
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (least > most) return {0, 1};
  return {least, std::max(most, least + 1)};
}

}  // namespace

void PsnrScale::setValues(const std::vector<double>& values) {
  m_values = values;
  m_range = rangeOf(values);
}

std::array<std::uint8_t, 3> PsnrScale::colour(std::size_t state) const {
  return falseColour((m_values[state] - m_range[0]) / (m_range[1] - m_range[0]));
}

}  // namespace hogelscope
