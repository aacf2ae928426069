// SPDX-License-Identifier: BSD-3-Clause
#include "chart/outcome_legend.h"

#include <QStringList>

namespace hogelscope {

QRgb colourOf(Outcome outcome) {
  constexpr std::array<QRgb, outcomeCount> colours{0xff79bfe8, 0xffffffff, 0xfff7dd4a, 0xffd55e00,
                                                   0xff3b1f5b};
  return colours[std::size_t(outcome)];
}

QRectF legendLine(const QRectF& area, int index) {
  constexpr int lines = 3;
  constexpr double step = 21;
  const double width = area.width() / 2;
  return {area.left() + index / lines * width, area.top() + index % lines * step, width, 16};
}

void paintOutcomeLegend(QPainter& painter, const QRectF& area, const OutcomeWords& words) {
  for (int k = 0; k < int(outcomeCount); ++k) {
    const QRectF line = legendLine(area, k);
    painter.setPen(QPen(Qt::black, 0.8));
    painter.setBrush(QColor(colourOf(Outcome(k))));
    painter.drawRect(QRectF(line.topLeft() + QPointF(0, 1), QSizeF(22, 14)));
    painter.setPen(Qt::black);
    painter.drawText(line.adjusted(32, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     words[std::size_t(k)]);
  }
}

void paintTitle(QPainter& painter, const QRectF& area, const QString& title) {
  QFont bold = painter.font();
  bold.setBold(true);
  painter.save();
  painter.setFont(bold);
  painter.drawText(area, Qt::AlignCenter, title);
  painter.restore();
}

QString titleOf(const InverseMethod& method) {
  const QStringList words = QString::fromStdString(method.name).split(' ');
  if (words[0] == "OpenCV") return "OpenCV, " + words[1] + " iterations";
  if (words[0] == "Newton") return "Newton, " + words[1] + " steps";
  return "certified (ours)";
}

}  // namespace hogelscope
