// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_overlay.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/colour_map.h"
#include "picture/scene_text.h"

namespace hogelscope {

namespace {

constexpr double margin = 12;  // to the picture's edges

/// Paints the parts of an overlay.
struct Overlay {
  Q_DECLARE_TR_FUNCTIONS(Overlay)

 public:
  QPainter& painter;
  const QSizeF size;
  const Tokens& colours;
  const QColor& behind;

  /// Writes on a plate, which keeps the text readable over the scene.
  void write(const QRectF& place, int flags, const QString& text, const QColor& ink) const {
    QColor plate = behind;
    plate.setAlpha(std::min(200, behind.alpha()));
    painter.fillRect(painter.boundingRect(place, flags, text).adjusted(-2, 0, 2, 0), plate);
    painter.setPen(ink);
    painter.drawText(place, flags, text);
  }

  void line(const QPointF& from, const QPointF& to, const QColor& colour, double width = 1.5,
            Qt::PenStyle style = Qt::SolidLine) const {
    painter.setPen(QPen(colour, width, style, Qt::FlatCap));
    painter.drawLine(from, to);
  }

  void ball(const QPointF& at, double radius, const QColor& rim, const QColor& fill) const {
    painter.setPen(QPen(rim, 1.5));
    painter.setBrush(fill);
    painter.drawEllipse(at, radius, radius);
  }

  /// The world's axes as balls, of which the positive ones have letters, the nearest last.
  void axes(const std::array<Vec3, 3>& axes) const {
    const QPointF middle(size.width() - scaled(42), scaled(42));
    std::array<int, 6> order{};  // 0 … 2: positive, 3 … 5: negative
    std::iota(order.begin(), order.end(), 0);
    const auto directionOf = [&](int k) { return (k < 3 ? 1.0 : -1.0) * axes[std::size_t(k % 3)]; };
    std::ranges::sort(order, {}, [&](int k) { return directionOf(k).z; });
    painter.setFont(textFont(TextSize::caption, QFont::DemiBold));
    for (const int k : order) {
      const QColor& colour = colours.axes[std::size_t(k % 3)];
      const Vec3 way = directionOf(k);
      const QPointF at = middle + scaled(26) * QPointF(way.x, -way.y);
      if (k < 3) line(middle, at, colour);
      ball(at, scaled(k < 3 ? 8 : 5), colour, k < 3 ? colour : Qt::transparent);
      painter.setPen(colours.canvas);
      if (k < 3)
        painter.drawText(QRectF(at - QPointF(20, 20), QSizeF(40, 40)), Qt::AlignCenter,
                         QString("XYZ")[k]);
    }
  }

  void arrow(const AxisArrow& arrow) const {
    const QColor& colour = colours.axes[std::size_t(arrow.axis)];
    const QPointF way = arrow.to - arrow.from;
    const QPointF along = way / std::hypot(way.x(), way.y());
    const QPointF across(-along.y(), along.x());
    line(arrow.from + 8 * along, arrow.to - 6 * along, colour, arrow.isHeld ? 4 : 2);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF(
        {arrow.to, arrow.to - 8 * along + 4 * across, arrow.to - 8 * along - 4 * across}));
    painter.setFont(textFont(TextSize::caption, QFont::DemiBold));
    painter.drawText(QRectF(arrow.to + 10 * along - QPointF(20, 20), QSizeF(40, 40)),
                     Qt::AlignCenter, QString("xyz")[arrow.axis]);
  }

  /// A length of 1, 2 or 5 times a power of ten.
  void scaleBar(double pixelSize) const {
    const double most = scaled(80) * pixelSize;
    double length = std::pow(10, std::floor(std::log10(most)));
    length *= most >= 5 * length ? 5 : most >= 2 * length ? 2 : 1;
    const double left = margin + 0.5;  // the middle of a pixel, so that thin lines are sharp
    const double right = left + length / pixelSize;
    const double y = std::floor(size.height() - margin) - scaled(18) + 0.5;
    for (const double x : {left, right}) line({x, y - 4}, {x, y}, colours.text2, 1);
    line({left, y}, {right, y}, colours.text2, 1);
    write({left, y + 2, 200.0, double(scaled(18))}, Qt::AlignLeft | Qt::AlignVCenter,
          SceneText::length(length), colours.text2);
  }

  /// Paints an outline and its entry of the legend, and returns where the next entry ends.
  double zone(const QPolygonF& outline, double right, const QString& text,
              Qt::PenStyle style) const {
    if (outline.isEmpty()) return right;
    painter.setPen(QPen(colours.good, 1.5, style));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(outline);
    const QRectF row(0, size.height() - margin - scaled(16), right, scaled(16));
    write(row, Qt::AlignRight | Qt::AlignVCenter, text, colours.text2);
    const double left = right - painter.fontMetrics().horizontalAdvance(text) - 6;
    line({left - 16, row.center().y()}, {left, row.center().y()}, colours.good, 1.5, style);
    return left - 28;
  }

  void psnrBar(const std::array<double, 2>& range) const {
    const QRectF bar(size.width() - margin - 8, std::floor(size.height() / 2) - 60, 8, 120);
    for (int y = 0; y < int(bar.height()); ++y) {
      const auto [r, g, b] = falseColour(1 - y / (bar.height() - 1));
      painter.fillRect(QRectF(bar.left(), bar.top() + y, bar.width(), 1), QColor(r, g, b));
    }
    const QRectF title(0, bar.top() - scaled(24), bar.right(), scaled(16));
    write(title, Qt::AlignRight | Qt::AlignVCenter, tr("PSNR, dB"), colours.text);
    for (const double share : {0.0, 0.5, 1.0}) {
      const double y = bar.bottom() - share * bar.height();
      line({bar.left() - 4, y}, {bar.left(), y}, colours.text2, 1);
      write({0, y - scaled(8), bar.left() - 7, double(scaled(16))},
            Qt::AlignRight | Qt::AlignVCenter,
            QString::number(range[0] + share * (range[1] - range[0]), 'f', 1), colours.text2);
    }
  }

  void measure(const std::vector<QPointF>& points, const QString& distance) const {
    if (points.size() == 2) line(points[0], points[1], colours.focus, 2);
    for (const QPointF& point : points) ball(point, 4, colours.focus, colours.canvas);
    if (points.size() < 2) return;
    const QPointF middle = (points[0] + points[1]) / 2;
    write(QRectF(middle - QPointF(100, scaled(24)), QSizeF(200, scaled(18))), Qt::AlignCenter,
          distance, colours.text);
  }
};

}  // namespace

void SceneOverlay::paint(QPainter& painter, const QSizeF& size, const Tokens& colours,
                         const QColor& behind) const {
  painter.setRenderHint(QPainter::Antialiasing);
  const Overlay overlay{painter, size, colours, behind};
  painter.setFont(textFont(TextSize::caption));
  if (pixelSize > 0) overlay.scaleBar(pixelSize);
  const double right = size.width() - margin;
  double next =
      overlay.zone(someZone, right,
                   isSheet ? Overlay::tr("views again") : Overlay::tr("sees a part"), Qt::DashLine);
  next = overlay.zone(wholeZone, next,
                      isSheet ? Overlay::tr("between flips") : Overlay::tr("viewing zone"),
                      Qt::SolidLine);
  for (const QPolygonF& plane : sharpDepths)
    overlay.zone(plane, next, Overlay::tr("sharp depths"), Qt::DotLine);
  for (const AxisArrow& arrow : arrows) overlay.arrow(arrow);
  for (const auto& [at, colour] : balls) overlay.ball(at, 6, colours.canvas, colour);
  painter.setFont(textFont(TextSize::caption));
  overlay.write(QRectF(labelPlace - QPointF(100, 0), QSizeF(200, scaled(18))), Qt::AlignCenter,
                label, colours.text);
  if (psnr) overlay.psnrBar(*psnr);
  overlay.measure(measured, distance);
  overlay.axes(axes);
}

}  // namespace hogelscope
