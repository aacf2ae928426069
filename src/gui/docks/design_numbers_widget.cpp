// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/design_numbers_widget.h"

#include <QPainter>

#include "chart/depth_bar.h"
#include "gui/session/session_forms.h"
#include "gui/widgets/colours.h"
#include "io/scene/view_source.h"
#include "ui_design_numbers.h"

namespace hogelscope {

namespace {

/// Returns a number with two or three digits that count; a dash for 0, which is not known.
QString inDigits(double value) {
  if (!(value > 0)) return "–";
  return QLocale().toString(value, value < 0.1 ? 'g' : 'f', value < 10 ? 2 : value < 100 ? 1 : 0);
}

QString inDigits(const std::array<double, 2>& pair, double factor = 1) {
  const QString across = inDigits(factor * pair[0]);
  const QString down = inDigits(factor * pair[1]);
  return across == down ? across : across + " × " + down;
}

QString rangeText(const std::array<double, 2>& depths) {
  return inCentimetres(depths[0]) + "\u2009…\u2009" + inCentimetres(depths[1]);
}

}  // namespace

/// The depths around the panel.
class DepthBar : public QWidget {
 public:
  using QWidget::QWidget;
  DesignNumbers numbers;
  std::optional<std::array<double, 2>> content;  ///< its depths, the back one first

  [[nodiscard]] QSize sizeHint() const override { return {scaled(180), scaled(40)}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Tokens& t = tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(textFont(TextSize::caption));
    paintDepthBar(painter, size(), numbers, content, {t.line, t.field, t.good, t.text, t.text3});
  }
};

DesignNumbersWidget::DesignNumbersWidget(const SessionModel* model, Form form)
    : m_ui(std::make_unique<Ui::DesignNumbers>()), m_model(model), m_bar(new DepthBar) {
  m_ui->setupUi(this);
  m_ui->designCard->setAttribute(Qt::WA_StyledBackground);
  m_bar->setObjectName("depthBar");
  m_bar->setToolTip(
      tr("Depths behind (−) and in front (+) of the panel in cm, as far apart as the eye has to "
         "focus from one to the other"));
  m_ui->column->setContentsMargins(scaled(12), scaled(4), scaled(12), scaled(4));
  m_ui->column->setSpacing(scaled(4));
  m_ui->column->insertWidget(1, m_bar);
  if (form == Form::strip) arrangeStrip();
  onAnyChange(model, this, &DesignNumbersWidget::showNumbers);
  showNumbers();
}

/// Moves all numbers into one row, without the depths below.
void DesignNumbersWidget::arrangeStrip() {
  m_bar->hide();
  m_ui->depthLegend->hide();
  m_ui->designCard->setObjectName("designStrip");
  m_ui->directionsPerPupil->hide();
  int column = 0;
  for (QLabel* cell : {m_ui->hogelPitch, m_ui->hogelArcmin, m_ui->degreesPerDirection,
                       m_ui->sharpDepths, m_ui->megapixels}) {
    cell->setObjectName(QStringLiteral("strip_") + cell->objectName());
    m_ui->cardLayout->setColumnStretch(column, cell == m_ui->sharpDepths ? 2 : 1);
    m_ui->cardLayout->addWidget(cell, 0, column++);
  }
}

DesignNumbersWidget::~DesignNumbersWidget() = default;

void DesignNumbersWidget::setSource(const std::optional<ViewSource>& source) {
  m_known = source ? DisplayParams(source->display) : DisplayParams();
  try {
    m_bar->content = source ? source->lightField->depths() : std::nullopt;
  } catch (const std::exception&) {
    m_bar->content.reset();  // a plugin that cannot tell its depths says so when a view is traced
  }
  showNumbers();
}

/// Returns zeros if they cannot be worked out.
DesignNumbers DesignNumbersWidget::numbers() const {
  const PanelParams display = withCounts(displayOf(m_model->session()), m_known);
  if (display.hogels[0] < 1 || display.directions[0] < 1) return {};
  try {
    return designNumbers(display, m_model->current().camera.eye);
  } catch (const std::exception&) {
    return {};  // the lens cannot be opened, which the view tells
  }
}

void DesignNumbersWidget::showNumbers() {
  setHidden(m_model->session().display.sheet.has_value());  // they are of hogels
  const Tokens& t = tokens();
  const DesignNumbers n = m_bar->numbers = numbers();
  m_bar->update();
  const std::array sharp{-n.depthBehind, n.depthFront};
  const auto say = [&](QLabel* cell, const QString& number, const QString& unit,
                       const QString& caption) {
    cell->setText(
        QString("<span style='font-size: %1px; font-weight: 600'>%2</span><span style='font-size: "
                "%3px; color: %4'> %5</span><br><span style='font-size: %3px; color: "
                "%6'>%7</span>")
            .arg(textFont(TextSize::number).pixelSize())
            .arg(number)
            .arg(textFont(TextSize::caption).pixelSize())
            .arg(t.text3.name(), unit, t.text2.name(), caption));
    cell->setAccessibleName(QString("%1 %2, %3").arg(number, unit, caption));
  };
  say(m_ui->hogelPitch, inDigits(n.hogelPitch, 1000), tr("mm"), tr("hogel pitch"));
  const bool isStrip = m_bar->isHidden();
  say(m_ui->hogelArcmin, inDigits(n.hogelArcmin), tr("arcmin"),
      isStrip ? tr("at the eye") : tr("hogel pitch at the eye"));
  say(m_ui->degreesPerDirection, inDigits(n.degreesPerDirection), "°", tr("each direction"));
  say(m_ui->directionsPerPupil, inDigits(n.directionsPerPupil), "", tr("directions in the pupil"));
  say(m_ui->megapixels, inDigits(n.megapixels), tr("Mpx"),
      isStrip ? tr("pixels") : tr("pixels behind lenses"));
  say(m_ui->sharpDepths, n.depthFront > 0 ? rangeText(sharp) : "–", "",
      tr("sharp for this eye, cm"));
  QString legend = tr("<span style='color: %1'>■</span> sharp").arg(t.good.name());
  if (m_bar->content) {
    const auto [back, front] = *m_bar->content;
    legend += tr(" &nbsp; <span style='color: %1'>▬</span> content %2 cm")
                  .arg(t.text.name(), rangeText(*m_bar->content));
    if (back >= sharp[0] && front <= sharp[1]) legend += tr(": all sharp");
  }
  m_ui->depthLegend->setText(QString("<span style='font-size: %1px; color: %2'>%3</span>")
                                 .arg(textFont(TextSize::caption).pixelSize())
                                 .arg(t.text2.name(), legend));
}

void DesignNumbersWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) showNumbers();
  QWidget::changeEvent(event);
}

}  // namespace hogelscope
