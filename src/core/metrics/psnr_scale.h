// SPDX-License-Identifier: BSD-3-Clause
// The colours of states by their PSNR.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace hogelscope {

/// Colour scale of the states' PSNR.
class PsnrScale {
 public:
  /// Sets the PSNR in dB of each state; infinite: identical, NaN: none.
  void setValues(const std::vector<double>& values);
  [[nodiscard]] bool hasValue(std::size_t state) const { return state < m_values.size(); }
  /// Returns the state's colour on the scale of the finite values. Identical is coloured as the
  /// largest, a state without a value is grey.
  [[nodiscard]] std::array<std::uint8_t, 3> colour(std::size_t state) const;
  /// Returns the least and the largest value in dB; none without values.
  [[nodiscard]] std::optional<std::array<double, 2>> range() const {
    return m_values.empty() ? std::nullopt : std::optional(m_range);
  }

 private:
  std::vector<double> m_values;
  std::array<double, 2> m_range{0, 1};  ///< dB
};

}  // namespace hogelscope
