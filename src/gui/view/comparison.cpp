// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/comparison.h"

#include <QFileInfo>
#include <QPainter>
#include <QStringList>
#include <cmath>
#include <utility>

#include "chart/histogram_chart.h"
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
  read({.name = QFileInfo(file).fileName(), .hasOwnDisplay = hasOwnDisplay}, other);
}

void Comparison::startDesign(const QString& name, const Session& session) {
  m_file.clear();
  read({.name = name, .hasOwnDisplay = true}, session);
}

void Comparison::read(Other other, const Session& session) {
  m_task.start([=, this](const Progress& progress) mutable {
    other.source = loadViewSource(session, progress);
    other.session = session;
    return [this, other] {
      m_other = other;
      Q_EMIT changed();
    };
  });
}

/// Compares with something that need not be read.
void Comparison::set(const Other& other) {
  m_task.abandon();
  m_file.clear();
  m_other = other;
  Q_EMIT changed();
}

void Comparison::startIdeal() {
  set({.name = tr("Ideal view"), .follows = Follows::ideal});
}

void Comparison::startDesigned() {
  set({.name = tr("As designed"), .follows = Follows::design});
}

void Comparison::startKept(const QString& name) {
  if (!m_own) return;  // it is being read
  set({.name = name, .source = m_own, .hasOwnDisplay = true});
}

void Comparison::showFrame(const std::shared_ptr<const LightFieldSource>& own,
                           const std::shared_ptr<const LightFieldSource>& other) {
  if (!m_other.source) return;
  if (m_own && m_other.source->lightField == m_own->lightField)  // not one that was read before
    m_other.source->lightField = own;
  else if (m_other.session && other)
    m_other.source->lightField = other;
}

void Comparison::stop() {
  set({});
}

std::optional<ViewSource> Comparison::other(const Session& session) const {
  std::optional<ViewSource> source = m_other.source;
  const bool isFollowed = m_other.follows == Follows::ideal
                              ? session.lightField.isLive()
                              : isDesigned() && !session.twin.isZero();
  if (isFollowed) source = m_own;
  if (!source) return source;
  if (isFollowed) {
    source->isIdeal = m_other.follows == Follows::ideal;
    if (isDesigned()) source->twin = nullptr;
    return source;
  }
  source->sampling = session.sampling;
  if (m_other.hasOwnDisplay) return source;
  source->twin = m_own ? m_own->twin : nullptr;
  source->display = displayOf(session);
  source->display.hogels = m_other.source->display.hogels;
  source->display.directions = m_other.source->display.directions;
  return source;
}

namespace {

QString words(const std::vector<double>& values) {
  const MetricSet metrics;
  QStringList parts;
  for (const auto& [index, title] : {std::pair(psnrSeenColumn, ComparisonMeter::tr("PSNR")),
                                     std::pair(ssimSeenColumn, ComparisonMeter::tr("SSIM")),
                                     std::pair(seenColumn, ComparisonMeter::tr("Seen in both"))}) {
    const MetricColumn& column = metrics.columns()[index];
    const QString unit =
        std::isfinite(values[index]) ? QString::fromStdString(column.unit) : QString();
    parts << QStringLiteral("%1 <b style='font-size:%2px'>%3</b> %4")
                 .arg(title)
                 .arg(textFont(TextSize::number).pixelSize())
                 .arg(QString::fromStdString(tableText(column, values[index])), unit)
                 .trimmed();
  }
  return parts.join(QStringLiteral(" &nbsp; "));
}

}  // namespace

QString textOf(const ComparisonFigures& figures) {
  if (figures.whole.empty()) return {};
  QString text = words(figures.whole) +
                 QStringLiteral(" &nbsp; <span style='color: %1'>%2</span>")
                     .arg(tokens().text3.name(), ComparisonMeter::tr("over what both see"));
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

void HistogramWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Tokens& t = tokens();
  painter.fillRect(rect(), t.canvas);
  painter.setFont(textFont(TextSize::caption));
  paintHistograms(painter, size(), m_histograms, m_names,
                  {t.canvas, t.text2, t.text3, t.line, t.grid, t.focus, t.series});
}

}  // namespace hogelscope
