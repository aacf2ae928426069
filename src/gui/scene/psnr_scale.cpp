// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/psnr_scale.h"

#include <vtkLookupTable.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>

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

PsnrScale::PsnrScale() {
  constexpr int colours = 256;
  m_table->SetNumberOfTableValues(colours);
  for (int k = 0; k < colours; ++k) {
    const auto [r, g, b] = falseColour(double(k) / (colours - 1));
    m_table->SetTableValue(k, r / 255.0, g / 255.0, b / 255.0);
  }
  m_bar->SetLookupTable(m_table);
  m_bar->SetTitle("PSNR, dB");
  m_bar->SetLabelFormat("%.1f");
  m_bar->SetNumberOfLabels(5);
  m_bar->SetVerticalTitleSeparation(8);
  m_bar->SetPosition(0.88, 0.3);
  m_bar->SetWidth(0.1);
  m_bar->SetHeight(0.45);
  m_bar->SetMaximumWidthInPixels(90);
  m_bar->UnconstrainedFontSizeOn();
  for (vtkTextProperty* text : {m_bar->GetTitleTextProperty(), m_bar->GetLabelTextProperty()}) {
    text->SetFontSize(13);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
    text->SetColor(0.9, 0.9, 0.9);
    text->SetBackgroundColor(0, 0, 0);  // readable over the panel
    text->SetBackgroundOpacity(0.6);
  }
  m_bar->VisibilityOff();
}

PsnrScale::~PsnrScale() = default;

void PsnrScale::setValues(const std::vector<double>& values) {
  m_values = values;
  m_range = rangeOf(values);
  m_table->SetRange(m_range[0], m_range[1]);
  m_bar->SetVisibility(!values.empty());
}

std::array<std::uint8_t, 3> PsnrScale::colour(std::size_t state) const {
  return falseColour((m_values[state] - m_range[0]) / (m_range[1] - m_range[0]));
}

}  // namespace hogelscope
