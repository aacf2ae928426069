// SPDX-License-Identifier: BSD-3-Clause
// Colour scale of the states' PSNR, and its colour bar.
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

  /// Sets the PSNR in dB of each state; infinite: identical, NaN: none. Without values the bar is
  /// hidden.
  void setValues(const std::vector<double>& values);
  [[nodiscard]] bool hasValue(std::size_t state) const { return state < m_values.size(); }
  /// Returns the state's colour on the scale of the finite values. Identical is coloured as the
  /// largest, a state without a value is grey.
  [[nodiscard]] std::array<std::uint8_t, 3> colour(std::size_t state) const;
  [[nodiscard]] vtkScalarBarActor* bar() const { return m_bar; }

 private:
  std::vector<double> m_values;
  std::array<double, 2> m_range{0, 1};  ///< dB
  vtkNew<vtkLookupTable> m_table;
  vtkNew<vtkScalarBarActor> m_bar;
};

}  // namespace hogelscope
