// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/comparison.h"

#include <QFileInfo>
#include <QPainter>
#include <QPainterPath>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/metrics/metric.h"
#include "gui/widgets/colours.h"
#include "io/documents/session_file.h"
#include "io/opening/session_around.h"

namespace hogelscope {

Comparison::Comparison(QObject* parent) : QObject(parent) {
  connect(&m_task, &Task::failed, this, [this](const QString& line) {
    m_file.clear();
    Q_EMIT failed(line);
  });
}

void Comparison::start(const Session& session, const QString& file) {
  const Session other = withLightField(session, file.toStdString());
  const bool hasOwnDisplay = isSessionFile(file.toStdString());
  m_file = file;
  m_task.start([=, this](const Progress& progress) {
    return [=, this, source = loadViewSource(other, progress)] {
      m_other = source;
      m_isIdeal = false;
      m_name = QFileInfo(file).fileName();
      m_hasOwnDisplay = hasOwnDisplay;
      Q_EMIT changed();
    };
  });
}

void Comparison::startIdeal() {
  m_task.abandon();
  m_file.clear();
  m_other.reset();
  m_isIdeal = true;
  m_name = tr("Ideal view");
  Q_EMIT changed();
}

void Comparison::startKept() {
  m_task.abandon();
  m_file.clear();
  m_other = m_own;
  m_isIdeal = false;
  m_hasOwnDisplay = true;
  m_name = tr("Display before");
  Q_EMIT changed();
}

void Comparison::stop() {
  m_task.abandon();
  m_file.clear();
  m_isIdeal = false;
  m_other.reset();
  m_name.clear();
  Q_EMIT changed();
}

std::optional<ViewSource> Comparison::other(const Session& session) const {
  if (m_isIdeal) {
    std::optional<ViewSource> ideal = m_own;
    if (!session.lightField.isLive()) ideal.reset();
    if (ideal) ideal->isIdeal = true;
    return ideal;
  }
  std::optional<ViewSource> source = m_other;
  if (!source) return source;
  source->sampling = session.sampling;
  if (m_hasOwnDisplay) return source;
  source->display = displayOf(session);
  source->display.hogels = m_other->display.hogels;
  source->display.directions = m_other->display.directions;
  return source;
}

namespace {

QString words(const std::vector<double>& values) {
  const MetricSet metrics;
  QStringList parts;
  for (const std::size_t index : {psnrSeenColumn, ssimSeenColumn, seenColumn}) {
    const MetricColumn& column = metrics.columns()[index];
    const QString unit =
        std::isfinite(values[index]) ? QString::fromStdString(column.unit) : QString();
    parts << QStringLiteral("%1 <b style='font-size:%2px'>%3</b> %4")
                 .arg(QString::fromStdString(column.title).toHtmlEscaped())
                 .arg(textFont(TextSize::number).pixelSize())
                 .arg(QString::fromStdString(tableText(column, values[index])), unit)
                 .trimmed();
  }
  return parts.join(QStringLiteral(" &nbsp; "));
}

}  // namespace

QString textOf(const ComparisonFigures& figures) {
  if (figures.whole.empty()) return {};
  QString text = words(figures.whole);
  if (!figures.inRegion.empty())
    text += "<br>" + ComparisonMeter::tr("Rectangle %1 × %2 at %3, %4: %5")
                         .arg(figures.region.width())
                         .arg(figures.region.height())
                         .arg(figures.region.x())
                         .arg(figures.region.y())
                         .arg(words(figures.inRegion));
  return text;
}

void ComparisonMeter::measure(const ShownPictures& pictures) {
  m_next = pictures;
  if (!m_task.isRunning()) start();
}

void ComparisonMeter::forget() {
  m_next.reset();
  m_task.abandon();
  Q_EMIT measured({});
}

void ComparisonMeter::start() {
  m_task.start([this, shown = *std::exchange(m_next, std::nullopt)](const Progress& progress) {
    return [this, figures = figuresOf(shown, progress)] { finish(figures); };
  });
}

void ComparisonMeter::finish(const ComparisonFigures& figures) {
  Q_EMIT measured(figures);
  if (m_next) start();
}

HistogramWidget::HistogramWidget(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setAccessibleName(tr("Histogram"));
  setToolTip(
      tr("How many seen pixels have which luma, 0 at the left to 255 at the right, heights being "
         "square roots: filled the session's own picture, as a line the other; of the marked "
         "rectangle where there is one"));
}

void HistogramWidget::setHistograms(const std::vector<Histogram>& histograms,
                                    const QStringList& names) {
  m_histograms = histograms;
  m_names = names;
  update();
}

/// Paints names, means and the values of the darkest and brightest hundredth, from the right.
void HistogramWidget::paintLegend(QPainter& painter) const {
  const int line = painter.fontMetrics().height();
  painter.setPen(tokens().text3);
  painter.drawText(QRect(4, 2, width(), line), Qt::AlignLeft, tr("Luma, √ of count"));
  int right = width() - 4;
  for (std::size_t which = m_histograms.size(); which-- > 0;) {
    const Histogram& counts = m_histograms[which];
    const QString text = tr("%1 · mean %2 · 1 %, 99 %: %3, %4")
                             .arg(m_names.value(qsizetype(which)))
                             .arg(meanOf(counts), 0, 'f', 1)
                             .arg(quantileOf(counts, 0.01))
                             .arg(quantileOf(counts, 0.99));
    const int left = right - painter.fontMetrics().horizontalAdvance(text);
    painter.setPen(tokens().text2);
    painter.drawText(left, 2 + painter.fontMetrics().ascent(), text);
    painter.fillRect(left - 14, 2 + line / 2 - 4, 8, 8, tokens().series[which]);
    right = left - 28;
  }
}

void HistogramWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), tokens().canvas);
  std::size_t most = 1;
  for (const Histogram& counts : m_histograms)
    most = std::max(most, *std::ranges::max_element(counts));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(textFont(TextSize::caption));
  const int ticks = painter.fontMetrics().height();
  const int bottom = height() - ticks;
  const int top = ticks + 4;
  for (int value = 0; value < 256; value += 32) {
    const int x = value * width() / 256;
    painter.fillRect(x, top, 1, bottom - top, tokens().grid);
    painter.setPen(tokens().text3);
    painter.drawText(QRect(x + 2, bottom, width(), ticks), Qt::AlignLeft, QString::number(value));
  }
  for (std::size_t which = 0; which < m_histograms.size(); ++which) {
    const Histogram& counts = m_histograms[which];
    const double step = double(width()) / double(counts.size());
    QPainterPath line(QPointF(0, bottom));
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const double share = std::sqrt(double(counts[k]) / double(most));
      const double y = bottom - share * (bottom - top);
      line.lineTo(step * double(k), y);
      line.lineTo(step * double(k + 1), y);
    }
    line.lineTo(width(), bottom);
    if (which == 0)
      painter.fillPath(line, tokens().series[0]);
    else
      painter.strokePath(line, QPen(tokens().series[1], 1.5));
  }
  paintLegend(painter);
}

}  // namespace hogelscope
