// SPDX-License-Identifier: BSD-3-Clause
#include "chart/histogram_chart.h"

#include <QCoreApplication>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

/// Paints names, means and the values of the darkest and brightest hundredth, from the right.
void paintLegend(QPainter& painter, int width, const std::vector<Histogram>& histograms,
                 const QStringList& names, const ChartColours& colours) {
  const int line = painter.fontMetrics().height();
  painter.setPen(colours.text2);
  painter.drawText(QRect(4, 2, width, line), Qt::AlignLeft,
                   QCoreApplication::translate("HistogramWidget", "Luma, √ of count"));
  int right = width - 4;
  for (std::size_t which = histograms.size(); which-- > 0;) {
    const Histogram& counts = histograms[which];
    const QString text =
        QCoreApplication::translate("HistogramWidget", "%1 · mean %2 · 1 %, 99 %: %3, %4")
            .arg(names.value(qsizetype(which)))
            .arg(meanOf(counts), 0, 'f', 1)
            .arg(quantileOf(counts, 0.01))
            .arg(quantileOf(counts, 0.99));
    const int left = right - painter.fontMetrics().horizontalAdvance(text);
    painter.setPen(colours.text);
    painter.drawText(left, 2 + painter.fontMetrics().ascent(), text);
    painter.fillRect(left - 14, 2 + line / 2 - 4, 8, 8, colours.series[which]);
    right = left - 28;
  }
}

}  // namespace

void paintHistograms(QPainter& painter, const QSize& size, const std::vector<Histogram>& histograms,
                     const QStringList& names, const ChartColours& colours) {
  const auto [width, height] = std::pair(size.width(), size.height());
  std::size_t most = 1;
  for (const Histogram& counts : histograms)
    most = std::max(most, *std::ranges::max_element(counts));
  painter.setRenderHint(QPainter::Antialiasing);
  const int ticks = painter.fontMetrics().height();
  const int bottom = height - ticks;
  const int top = ticks + 4;
  for (int value = 0; value < 256; value += 32) {
    const int x = value * width / 256;
    painter.fillRect(x, top, 1, bottom - top, colours.grid);
    painter.setPen(colours.text2);
    painter.drawText(QRect(x + 2, bottom, width, ticks), Qt::AlignLeft, QString::number(value));
  }
  for (std::size_t which = 0; which < histograms.size(); ++which) {
    const Histogram& counts = histograms[which];
    const double step = double(width) / double(counts.size());
    QPainterPath line(QPointF(0, bottom));
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const double share = std::sqrt(double(counts[k]) / double(most));
      const double y = bottom - share * (bottom - top);
      line.lineTo(step * double(k), y);
      line.lineTo(step * double(k + 1), y);
    }
    line.lineTo(width, bottom);
    if (which == 0)
      painter.fillPath(line, colours.series[0]);
    else
      painter.strokePath(line, QPen(colours.series[which], 1.5));
  }
  paintLegend(painter, width, histograms, names, colours);
}

}  // namespace hogelscope
