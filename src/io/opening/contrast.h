// SPDX-License-Identifier: BSD-3-Clause
// The contrast of previews, stretched for dark captures.
#pragma once

#include <cstdint>
#include <vector>

namespace hogelscope {

/// Maps code values before rounding (0 to 255) to those of a preview: as they are, or stretched to
/// the whole range if even the brightest are dark, which a raw capture often is.
class Contrast {
 public:
  /// Takes the values of all channels. They are stretched from their 0.5th percentile to their
  /// 99.5th if the latter is below a quarter of the range.
  explicit Contrast(std::vector<float> values);

  [[nodiscard]] bool isStretched() const { return m_gain != 1; }
  [[nodiscard]] std::uint8_t operator()(float value) const;

 private:
  float m_low = 0;
  float m_gain = 1;
};

}  // namespace hogelscope
