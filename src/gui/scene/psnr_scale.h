// SPDX-License-Identifier: BSD-3-Clause
// Colours for the states' PSNR, and the colour bar that explains them.
#pragma once

#include <vtkNew.h>

#include <array>
#include <cstdint>
#include <vector>

class vtkLookupTable;
class vtkScalarBarActor;

namespace hogelscope {

class PsnrScale {
 public:
  PsnrScale();
  ~PsnrScale();
  PsnrScale(const PsnrScale&) = delete;
  PsnrScale& operator=(const PsnrScale&) = delete;

  /// In dB, by state; infinite: identical, NaN: none. Without values the bar is not shown.
  void setValues(const std::vector<double>& values);
  [[nodiscard]] bool hasValue(std::size_t state) const { return state < m_values.size(); }
  /// From the least to the largest finite value; identical as the largest, grey for none.
  [[nodiscard]] std::array<std::uint8_t, 3> colour(std::size_t state) const;
  [[nodiscard]] vtkScalarBarActor* bar() const { return m_bar; }

 private:
  std::vector<double> m_values;
  std::array<double, 2> m_range{0, 1};  ///< dB
  vtkNew<vtkLookupTable> m_table;
  vtkNew<vtkScalarBarActor> m_bar;
};

}  // namespace hogelscope
