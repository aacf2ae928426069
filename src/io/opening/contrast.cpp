// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/contrast.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

Contrast::Contrast(std::vector<float> values) {
  if (values.empty()) return;
  const auto percentile = [&values](double share) {
    const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  constexpr float dark = 64;
  const float low = percentile(0.005), high = percentile(0.995);
  if (high >= dark || !(high > low)) return;
  m_low = low;
  m_gain = 255 / (high - low);
}

std::uint8_t Contrast::operator()(float value) const {
  return std::uint8_t(std::lround(std::clamp((value - m_low) * m_gain, 0.0F, 255.0F)));
}

}  // namespace hogelscope
