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

/// A number of the card.
struct NumberCell {
  QLabel* label;
  QString number;
  QString unit;
  QString caption;
  QString tip = {};  ///< "": the form's own
};

void fillCell(const NumberCell& cell) {
  const auto& [label, number, unit, caption, tip] = cell;
  const Tokens& t = tokens();
  label->setText(
      QString("<span style='font-size: %1px; font-weight: 600'>%2</span><span style='font-size: "
              "%3px; color: %4'> %5</span><br><span style='font-size: %3px; color: "
              "%6'>%7</span>")
          .arg(textFont(TextSize::number).pixelSize())
          .arg(number)
          .arg(textFont(TextSize::caption).pixelSize())
          .arg(t.text3.name(), unit, t.text2.name(), caption));
  label->setAccessibleName(QString("%1 %2, %3").arg(number, unit, caption));
  constexpr const char* own = "tipOfTheForm";
  if (!label->property(own).isValid()) label->setProperty(own, label->toolTip());
  label->setToolTip(tip.isEmpty() ? label->property(own).toString() : tip);
}

}  // namespace

/// The depths around the panel.
class DepthBar : public QWidget {
 public:
  using QWidget::QWidget;
  SharpDepths sharp;
  std::optional<std::array<double, 2>> content;  ///< its depths, the back one first

  [[nodiscard]] QSize sizeHint() const override { return {scaled(180), scaled(40)}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Tokens& t = tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(textFont(TextSize::caption));
    paintDepthBar(painter, size(), sharp, content, {t.line, t.field, t.good, t.text, t.text3});
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
  m_ui->number4->hide();
  int column = 0;
  for (QLabel* cell : {m_ui->number1, m_ui->number2, m_ui->number3, m_ui->number6, m_ui->number5}) {
    cell->setObjectName(QStringLiteral("strip_") + cell->objectName());
    m_ui->cardLayout->setColumnStretch(column, cell == m_ui->number6 ? 2 : 1);
    m_ui->cardLayout->addWidget(cell, 0, column++);
  }
}

DesignNumbersWidget::~DesignNumbersWidget() = default;

void DesignNumbersWidget::setSource(const std::optional<ViewSource>& source) {
  m_known = source ? DisplayParams(source->display) : DisplayParams();
  m_bar->content.reset();
  const LiveScene* const scene = source ? source->lightField->scene() : nullptr;
  try {
    if (scene != nullptr) m_bar->content = scene->depths();
  } catch (const std::exception&) {
    // a plugin that cannot tell its depths says so when a view is traced
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

/// Returns none for a display of hogels, and where they cannot be worked out. Without a number of
/// views what depends on it is 0.
std::optional<SheetNumbers> DesignNumbersWidget::numbersOfSheet() const {
  const Session& session = m_model->session();
  if (!session.display.sheet) return std::nullopt;
  const int views = viewsOnSheet(session);
  const Vec3 eye = eyePlaceOf(session.display, m_model->current().camera.eye).point;
  try {
    SheetNumbers numbers = sheetNumbers(*session.display.sheet, std::max(views, 1), eye);
    if (views == 0)
      numbers.viewsPerMetre = numbers.lobe = numbers.depthFront = numbers.depthBehind = 0;
    return numbers;
  } catch (const std::exception&) {
    return std::nullopt;  // a figure of the calibration is missing
  }
}

void DesignNumbersWidget::showHogels(const DesignNumbers& n) {
  const bool isStrip = m_bar->isHidden();
  for (const NumberCell& cell : std::initializer_list<NumberCell>{
           {m_ui->number1, inDigits(n.hogelPitch, 1000), tr("mm"), tr("hogel pitch")},
           {m_ui->number2, inDigits(n.hogelArcmin), tr("arcmin"),
            isStrip ? tr("at the eye") : tr("hogel pitch at the eye")},
           {m_ui->number3, inDigits(n.degreesPerDirection), "°", tr("each direction")},
           {m_ui->number4, inDigits(n.directionsPerPupil), "", tr("directions in the pupil")},
           {m_ui->number5, inDigits(n.megapixels), tr("Mpx"),
            isStrip ? tr("pixels") : tr("pixels behind lenses")}})
    fillCell(cell);
}

void DesignNumbersWidget::showSheet(const SheetNumbers& n) {
  const double own = m_model->current().stereo.ipd;
  const double ipd = own > 0 ? own : m_model->session().depth.ipd;
  for (const NumberCell& cell : std::initializer_list<NumberCell>{
           {m_ui->number1, inDigits(n.viewsPerMetre), tr("views/m"), tr("sideways"),
            tr("How many views pass as the eye moves sideways by a metre")},
           {m_ui->number2, inDigits(n.cone), "°", tr("viewing cone"),
            tr("The angle into which the lenses spread the views once")},
           {m_ui->number3, inDigits(100 * n.width()), tr("cm"), tr("between flips"),
            tr("The width of the viewing cone at the eye's distance. Beyond it the views begin "
               "again")},
           {m_ui->number4, inDigits(n.lobe), tr("views"), tr("in one place, rms"),
            tr("What one place sees about its own view: the width of a sub-pixel and the lenses' "
               "slant mix neighbours")},
           {m_ui->number5, inDigits(100 * n.pseudoscopic(ipd)), "%", tr("see eyes swapped"),
            tr("The share of places of a head from which a flip lies between its eyes, so that "
               "they see their pictures exchanged")}})
    fillCell(cell);
}

void DesignNumbersWidget::showNumbers() {
  const bool isSheet = m_model->session().display.sheet.has_value();
  const std::optional<SheetNumbers> sheet = numbersOfSheet();
  setHidden(isSheet && !sheet);
  if (sheet) {
    showSheet(*sheet);
    m_bar->sharp = *sheet;
  } else {
    const DesignNumbers hogels = numbers();
    showHogels(hogels);
    m_bar->sharp = hogels;
  }
  const SharpDepths& n = m_bar->sharp;
  m_bar->update();
  const std::array sharp{-n.depthBehind, n.depthFront};
  fillCell({m_ui->number6, n.depthFront > 0 ? rangeText(sharp) : "–", "",
            tr("sharp for this eye, cm"),
            isSheet ? tr("The depths behind (−) and in front (+) of the panel where lines as fine "
                         "as the lenses keep 64 % of the contrast that they have on the panel")
                    : QString()});
  const Tokens& t = tokens();
  QString legend = tr("<span style='color: %1'>■</span> sharp").arg(t.good.name());
  if (m_bar->content) {
    const auto [back, front] = *m_bar->content;
    legend += tr(" &nbsp; <span style='color: %1'>▬</span> content %2 cm")
                  .arg(t.text.name(), rangeText(*m_bar->content));
    if (back >= sharp[0] && front <= sharp[1]) legend += tr(": sharp");
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
