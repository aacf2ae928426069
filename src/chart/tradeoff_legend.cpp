// SPDX-License-Identifier: BSD-3-Clause
#include "chart/tradeoff_legend.h"

#include <QFontMetricsF>
#include <QStringList>
#include <algorithm>

#include "chart/tradeoff_axes.h"
#include "chart/tradeoff_numbers.h"

namespace hogelscope {

namespace {

double widest(const QStringList& texts, const QFont& font) {
  const QFontMetricsF metrics(font);
  double width = 0;
  for (const QString& text : texts) width = std::max(width, metrics.horizontalAdvance(text));
  return width;
}

}  // namespace

QString figureText(double value) {
  const bool isLong = value >= 99.5 && value < 1e6;
  return isLong ? QString::number(value, 'f', 0) : QString::number(value, 'g', 2);
}

QString legendName(const TradeoffRow& row) {
  return QString::fromStdString(row.method) + (row.isSampled ? "*" : "");
}

TradeoffLegend legendOf(const std::vector<TradeoffRow>& rows, const QRectF& area, const QFont& font,
                        double size) {
  TradeoffLegend legend;
  QStringList names;
  QStringList times{"ms"};
  QStringList errors{"error"};
  for (const std::size_t row : numbered(rows)) {
    legend.lines.push_back({row, std::nullopt, {}});
    for (const Purpose purpose : purposesOf(rows, row)) legend.lines.push_back({row, purpose, {}});
    names += legendName(rows[row]);
    times += figureText(rows[row].milliseconds);
    errors += figureText(rows[row].rmse);
  }
  const double pitch = area.height() / static_cast<double>(legend.lines.size() + 1);
  constexpr double leastReadable = 7;
  constexpr double leastWithFigures = 10;
  for (;; --size) {
    legend.font = sized(font, size);
    const double em = QFontMetricsF(legend.font).height();
    legend.numberEnd = 1.5 * em + widest({QString::number(names.size())}, sized(font, size, true));
    legend.name = legend.numberEnd + 0.5 * em;
    const double nameEnd = legend.name + widest(names, sized(font, size, true));
    legend.timeEnd = area.width() - widest(errors, legend.font) - 0.6 * em;
    const bool hasFigures = nameEnd + 0.6 * em + widest(times, legend.font) <= legend.timeEnd;
    if (!hasFigures) legend.timeEnd = 0;
    const bool fits =
        1.05 * em <= pitch && nameEnd <= area.width() && (hasFigures || size < leastWithFigures);
    if (fits || size <= leastReadable) break;
  }
  const double height = std::min(pitch, 1.4 * QFontMetricsF(legend.font).height());
  double top = area.top();
  for (LegendLine& line : legend.lines)
    line.box = {area.left(), top += height, area.width(), height};
  return legend;
}

}  // namespace hogelscope
