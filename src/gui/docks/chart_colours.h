// SPDX-License-Identifier: BSD-3-Clause
// Colours of charts in the window.
#pragma once

#include "chart/painting.h"
#include "gui/widgets/colours.h"

namespace hogelscope {

/// Returns the colours of charts in the scheme in use.
inline ChartColours chartColours() {
  const Tokens& t = tokens();
  return {t.canvas, t.text, t.text2, t.line, t.grid, t.focus, t.series};
}

/// Returns the font of charts, scaled as the user chose.
inline QFont chartFont() {
  constexpr int pixels = 12;
  QFont font = textFont(TextSize::base);
  font.setPixelSize(scaled(pixels));
  return font;
}

}  // namespace hogelscope
