// SPDX-License-Identifier: BSD-3-Clause
#include "chart/depth_bar.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

QString inCentimetres(double depth) {
  const double size = 100 * std::abs(depth);
  return (depth < 0 ? "−" : "+") +
         (std::isfinite(size) ? QString::number(size, 'f', size < 10 ? 1 : 0) : "∞");
}

void paintDepthBar(QPainter& painter, const QSizeF& size, const SharpDepths& sharp,
                   const std::optional<std::array<double, 2>>& content,
                   const DepthColours& colours) {
  const double height = size.height();
  const QRectF bar(0.5, 0.5, size.width() - 1, height / 2);
  painter.setPen(colours.frame);
  painter.setBrush(colours.ground);
  painter.drawRoundedRect(bar, 4, 4);
  if (!(sharp.distance > 0)) return;
  const auto dioptresOf = [&](double depth) {  // at the eye and behind it: almost at the eye
    return dioptresAt(std::min(depth, 0.999 * sharp.distance), sharp.distance);
  };
  const double front = dioptresOf(sharp.depthFront);
  double most = front;
  for (const double depth : content.value_or(std::array{0.0, 0.0}))
    most = std::max(most, std::abs(dioptresOf(depth)));
  const double ends = 1.4 * std::min(most, 3 * front);  // content that is far out is cut
  const auto xOf = [&](double depth) {
    return bar.center().x() + bar.width() / 2 * std::clamp(dioptresOf(depth) / ends, -1.0, 1.0);
  };
  const auto span = [&](double from, double to, double inset) {
    return QRectF(QPointF(xOf(from), bar.top() + inset), QPointF(xOf(to), bar.bottom() - inset));
  };
  const QRectF within = span(-sharp.depthBehind, sharp.depthFront, 0);
  painter.setOpacity(0.4);
  painter.fillRect(within, colours.sharp);
  painter.setOpacity(1);
  painter.setPen(QPen(colours.sharp, 1.5));
  painter.drawLine(within.topLeft(), within.bottomLeft());
  painter.drawLine(within.topRight(), within.bottomRight());
  painter.setPen(colours.text);
  painter.drawLine(QPointF(bar.center().x(), bar.top()), QPointF(bar.center().x(), bar.bottom()));
  for (const double depth : {-sharp.depthBehind, 0.0, sharp.depthFront})
    painter.drawText(QRectF(xOf(depth) - 0.6 * height, 0.55 * height, 1.2 * height, 0.45 * height),
                     Qt::AlignCenter, depth == 0 ? "0" : inCentimetres(depth));
  painter.setPen(Qt::NoPen);
  painter.setBrush(colours.content);
  if (content)
    painter.drawRoundedRect(span((*content)[0], (*content)[1], bar.height() / 2 - 3), 3, 3);
}

}  // namespace hogelscope
