// SPDX-License-Identifier: BSD-3-Clause
#include "chart/method_texts.h"

#include <QCoreApplication>
#include <array>
#include <cmath>

#include "chart/tradeoff_chart.h"

namespace hogelscope {

namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("hogelscope::TradeoffWidget", text);
}

QString nameOf(const TradeoffRow& row) {
  return QString::fromStdString(row.method).toHtmlEscaped();
}

QString styled(const QColor& colour, double pixels, const QString& words) {
  return QString("<span style='color:%1; font-size:%2px'>%3</span>")
      .arg(colour.name())
      .arg(std::lround(pixels))
      .arg(words);
}

double captionOf(double em) {
  return 11 * em / 13;
}

QString noErrorText(const TradeoffRow& row) {
  return row.psnrLow < row.psnrHigh ? tr("no error seen") : tr("no error");
}

constexpr std::array titles{"Moving view", "Default", "For a paper"};  // of each Purpose

}  // namespace

QString rateText(const TradeoffRow& row) {
  return figureText(1000 / row.milliseconds);
}

QString detailsOf(const std::vector<TradeoffRow>& rows, std::size_t which,
                  const ChartColours& colours, double em) {
  const TradeoffRow& row = rows[which];
  const double spread = spreadOf(row);
  const QString runs =
      std::isnan(spread) ? tr(", timed once") : tr(" ± %1 %").arg(figureText(100 * spread));
  QString error = row.rmse > 0 ? tr("RMS <b>%1</b> · PSNR <b>%2 dB</b>")
                                     .arg(figureText(row.rmse))
                                     .arg(row.psnr, 0, 'f', 1)
                               : noErrorText(row);
  if (row.psnrLow < row.psnrHigh)
    error += tr(" (%1 to %2)").arg(row.psnrLow, 0, 'f', 1).arg(row.psnrHigh, 0, 'f', 1);
  QString text =
      QString("<b>%1</b><br>%2%3 · <b>%4</b> %5<br>%6")
          .arg(nameOf(row), timeText(row.milliseconds), runs, rateText(row), tr("views/s"), error);
  const auto note = [&](const QString& words) {
    text += "<br>" + styled(colours.text2, captionOf(em), words);
  };
  if (const auto better = betterThan(rows, which)) {
    const bool isFaster = rows[*better].milliseconds < row.milliseconds;
    const bool isBetter = rows[*better].rmse < row.rmse;
    note(tr("%1 is %2 and %3")
             .arg(nameOf(rows[*better]), isFaster ? tr("faster") : tr("as fast"),
                  isBetter ? tr("better") : tr("as accurate")));
  }
  if (row.isSampled) note(tr("measured on part of the pixels"));
  return text;
}

QString errorText(const TradeoffRow& row) {
  if (!(row.psnrLow < row.psnrHigh)) return figureText(row.rmse);
  const auto [least, most] = errorRangeOf(row);
  return tr("%1 (%2 to %3)").arg(figureText(row.rmse), figureText(least), figureText(most));
}

QString cardText(const std::vector<Purpose>& alike, const TradeoffRow& row, bool isUsed,
                 bool isLine, const ChartColours& colours, double em) {
  const QColor& faint = colours.text2;
  QString title;
  for (const Purpose purpose : alike)
    title += styled(ringColour(purpose, colours), em, QStringLiteral("<b>○</b> ")) +
             styled(faint, em, tr(titles[std::size_t(purpose)]) + "&nbsp; ");
  const QString error = row.rmse > 0 ? tr("error %1").arg(figureText(row.rmse)) : noErrorText(row);
  const QString figures =
      styled(faint, captionOf(em),
             tr("%1 · %2 views/s · %3").arg(timeText(row.milliseconds), rateText(row), error));
  const QString use = styled(isUsed ? colours.accent : faint, captionOf(em),
                             isUsed ? tr("in use") : tr("click to use"));
  const QString name = "<b>" + nameOf(row) + "</b>";
  const QString lines =
      isLine ? "<tr><td>%1%2 &nbsp; %3 &nbsp; %4</td></tr>"
             : "<tr><td>%1</td><td align=right>%2</td></tr><tr><td colspan=2>%3</td></tr>"
               "<tr><td colspan=2>%4</td></tr>";
  return "<table width='100%' cellspacing=0 cellpadding=1 style='white-space:nowrap'>" +
         lines.arg(title, isLine ? "" : use,
                   styled(isLine && isUsed ? colours.accent : colours.text,
                          isLine ? em : 15 * em / 13, name),
                   figures) +
         "</table>";
}

}  // namespace hogelscope
