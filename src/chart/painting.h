// SPDX-License-Identifier: BSD-3-Clause
// Charts as files: one paint function makes the PNG, the SVG and the widget.
#pragma once

#include <QGuiApplication>
#include <QPainter>
#include <QSize>
#include <functional>
#include <optional>
#include <string>

namespace hogelscope {

/// Lets Qt paint text where no window is wanted: without X. For batch mode; keep it while painting.
class OffscreenPainting {
 public:
  OffscreenPainting();

 private:
  int m_argc = 1;
  char m_name[11] = "hogelscope";
  char* m_argv[2] = {m_name, nullptr};
  std::optional<QGuiApplication> m_application;  ///< none where there is one already
};

/// Paints on an area of `size`, in points, from (0, 0).
using Paint = std::function<void(QPainter& painter, const QSizeF& size)>;

/// The bytes of the files. Text is DejaVu Sans; PNG has twice as many pixels as points.
std::string pngOf(const Paint& paint, const QSize& size);
std::string svgOf(const Paint& paint, const QSize& size, const std::string& title);

}  // namespace hogelscope
