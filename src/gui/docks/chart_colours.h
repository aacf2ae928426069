// SPDX-License-Identifier: BSD-3-Clause
// Colours, texts and marks of charts in the window.
#pragma once

#include <QPixmap>

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

/// Returns a transparent square with what `paint` paints; `ratio`: its pixels per pixel of the
/// window.
inline QPixmap pixmapOf(int side, double ratio, const Paint& paint) {
  QPixmap pixmap(QSize(side, side) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paint(painter, QSizeF(side, side));
  return pixmap;
}

}  // namespace hogelscope
