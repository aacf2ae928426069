// SPDX-License-Identifier: BSD-3-Clause
// Export of charts to files: one paint function for PNG, SVG and the widget.
#pragma once

#include <QColor>
#include <QGuiApplication>
#include <QPainter>
#include <QSize>
#include <array>
#include <functional>
#include <optional>
#include <string>

namespace hogelscope {

/// Enables Qt's text painting without a window or X, for batch mode. Keep it while painting.
class OffscreenPainting {
 public:
  OffscreenPainting();

 private:
  int m_argc = 1;
  char m_name[11] = "hogelscope";
  char* m_argv[2] = {m_name, nullptr};
  std::optional<QGuiApplication> m_application;  ///< none if an application exists already
};

/// The colours of a chart.
struct ChartColours {
  QColor background;
  QColor text, text2;            ///< text2: axes and captions
  QColor line, grid;             ///< frames; the lines at ticks
  QColor accent;                 ///< what is chosen
  std::array<QColor, 4> series;  ///< circle, square, triangle, diamond
};

/// Returns a false colour, 0 … 1.
QColor shadeColour(double share);

/// Returns the colours of files: dark on white.
const ChartColours& printColours();

/// Paints on an area of `size`, in pixels of a window, from (0, 0).
using Paint = std::function<void(QPainter& painter, const QSizeF& size)>;

/// The widths of charts for a column and for a page of a paper (page/figure.h), in pixels.
constexpr int columnPixels = 366;
constexpr int pagePixels = 757;

/// Returns the bytes of a PNG; the next function those of an SVG. Text is DejaVu Sans of 12 pixels.
/// A PNG has twice as many pixels in each direction; an SVG is `millimetres` wide, or, with 0, has
/// pixels of 2/3 pt, so that text is 8 pt.
std::string pngOf(const Paint& paint, const QSize& size);
std::string svgOf(const Paint& paint, const QSize& size, const std::string& title,
                  double millimetres = 0);

}  // namespace hogelscope
