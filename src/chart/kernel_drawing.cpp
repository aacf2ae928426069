// SPDX-License-Identifier: BSD-3-Clause
#include "chart/kernel_drawing.h"

#include <QObject>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "chart/painting.h"

namespace hogelscope {

namespace {

/// Returns the square of the taps; a line of text follows below it.
QRectF squareIn(const QSizeF& size, const QFontMetrics& text) {
  const double below = text.height() + 6;
  const double side = std::max(1.0, std::min(size.width() - 8, size.height() - below - 4));
  return {(size.width() - side) / 2, 4, side, side};
}

/// Returns a scaled font. The chart's font has a size in pixels, the window's one in points.
QFont smaller(QFont font, double factor) {
  if (font.pixelSize() > 0)
    font.setPixelSize(int(std::lround(factor * font.pixelSize())));
  else
    font.setPointSizeF(factor * font.pointSizeF());
  return font;
}

/// Returns a weight in per cent, in short form.
QString percent(double weight) {
  return weight < 0.001 ? QString::number(100 * weight, 'g', 1)
                        : QString::number(100 * weight, 'f', 1);
}

/// A kernel's painter, with what its parts share.
struct KernelPainter {
  QPainter& painter;
  const QRectF& square;
  const PsfParams& params;
  const std::vector<double>& weights;
  double most = std::ranges::max(weights);

  /// Returns the rectangle of tap k.
  [[nodiscard]] QRectF cell(int k) const {
    const double width = square.width() / params.windowSize;
    const QPointF tap(k % params.windowSize, k / params.windowSize);
    return {square.topLeft() + width * tap, QSizeF(width, width)};
  }

  void cells() const {
    const bool hasGrid = cell(0).width() >= 6;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(hasGrid ? QPen(QColor(0, 0, 0, 90)) : QPen(Qt::NoPen));
    for (int k = 0; k < int(weights.size()); ++k) {
      painter.setBrush(shadeColour(weights[std::size_t(k)] / most));
      // A small overlap prevents background lines between cells without a grid.
      const double overlap = hasGrid ? 0 : 1;
      painter.drawRect(cell(k).adjusted(0, 0, overlap, overlap).intersected(square));
    }
    painter.setRenderHint(QPainter::Antialiasing, true);
  }

  /// Paints a circle of radius sigma around the middle tap, clipped to the window.
  void sigma() const {
    const double radius = params.sigma * square.width() / params.windowSize;
    QPainterPath window, circle;
    window.addRect(square);
    circle.addEllipse(square.center(), radius, radius);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 160), 3.5), QPen(Qt::white, 1.5, Qt::DashLine)}) {
      // Intersects paths, because Qt's SVG ignores clipping.
      const QPainterPath line = QPainterPathStroker(pen).createStroke(circle);
      painter.fillPath(line.intersected(window), pen.brush());
    }
  }

  void numbers() const {
    painter.setFont(smaller(painter.font(), 0.85));
    if (cell(0).width() < painter.fontMetrics().horizontalAdvance("100.0") + 2) return;
    for (int k = 0; k < int(weights.size()); ++k) {
      const double weight = weights[std::size_t(k)];
      painter.setPen(weight > 0.6 * most ? Qt::black : Qt::white);
      painter.drawText(cell(k), Qt::AlignCenter, percent(weight));
    }
  }
};

}  // namespace

void paintKernel(QPainter& painter, const QSizeF& size, const PsfParams& params,
                 const std::vector<double>& weights) {
  if (weights.empty()) {
    painter.drawText(QRectF({0, 0}, size), Qt::AlignCenter, QObject::tr("no kernel: sigma is 0"));
    return;
  }
  const QRectF square = squareIn(size, painter.fontMetrics());
  painter.save();
  const KernelPainter kernel{painter, square, params, weights};
  kernel.cells();
  if (params.windowSize > 1) kernel.sigma();
  kernel.numbers();
  painter.restore();
  const QRectF below(0, square.bottom(), size.width(), size.height() - square.bottom());
  painter.drawText(below, Qt::AlignCenter,
                   params.windowSize == 1 ? QObject::tr("no leakage")
                                          : QObject::tr("weights in %, circle: sigma"));
}

std::optional<QPoint> tapAt(const QPointF& place, const QSizeF& size, const QFontMetrics& text,
                            int windowSize) {
  const QRectF square = squareIn(size, text);
  if (!square.contains(place)) return std::nullopt;
  const QPointF inside = (place - square.topLeft()) / square.width() * windowSize;
  return QPoint(std::min(int(inside.x()), windowSize - 1),
                std::min(int(inside.y()), windowSize - 1));
}

}  // namespace hogelscope
