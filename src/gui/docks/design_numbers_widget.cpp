// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/design_numbers_widget.h"

#include <QPainter>
#include <cmath>

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
  constexpr double seen = 0.01;  // a smaller difference is not worth the room
  if (std::abs(pair[0] - pair[1]) < seen * pair[0]) return inDigits(factor * pair[0]);
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
  QString tip = {};     ///< "": the form's own
  QString change = {};  ///< from the display as it was opened
};

/// Returns how much larger a number has become, in percent; "" where it is as it was, or one of
/// them is not known.
QString changeText(double now, double before) {
  if (!(now > 0) || !(before > 0)) return {};
  const double percent = 100 * (now / before - 1);
  if (std::abs(percent) < 0.5) return {};
  return QString("%1%2\u2009%").arg(percent < 0 ? "−" : "+").arg(std::abs(percent), 0, 'f', 0);
}

/// Makes a cell's texts fit into its room: a unit that does not goes to the caption, and then the
/// number becomes smaller. Returns the number's size in pixels.
int fitCell(NumberCell& cell) {
  constexpr int padding = 16;
  const QFontMetrics caption(textFont(TextSize::caption));
  QFont font = textFont(TextSize::number, QFont::DemiBold);
  const auto fits = [&] {
    return QFontMetrics(font).horizontalAdvance(cell.number) +
               caption.horizontalAdvance("  " + cell.unit + cell.change) <=
           cell.label->width() - scaled(padding);
  };
  if (!fits() && !cell.unit.isEmpty()) {
    cell.caption += ", " + cell.unit;
    cell.unit.clear();
  }
  while (!fits() && font.pixelSize() > textFont(TextSize::caption).pixelSize())
    font.setPixelSize(font.pixelSize() - 1);
  return font.pixelSize();
}

void fillCell(NumberCell cell) {
  cell.number.replace(' ', QChar(QChar::Nbsp));
  const QString name = QString("%1 %2, %3").arg(cell.number, cell.unit, cell.caption);
  const int size = fitCell(cell);
  const auto& [label, number, unit, caption, tip, change] = cell;
  const Tokens& t = tokens();
  label->setText(
      QString("<span style='font-size: %1px; font-weight: 600'>%2</span><span style='font-size: "
              "%3px; color: %4'> %5</span><span style='font-size: %3px; color: %8'> %9</span><br>"
              "<span style='font-size: %3px; color: %6'>%7</span>")
          .arg(size)
          .arg(number)
          .arg(textFont(TextSize::caption).pixelSize())
          .arg(t.text3.name(), unit, t.text2.name(), caption, t.amber.name(), change));
  label->setAccessibleName(name);
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
  connect(model, &SessionModel::opened, this, [this] {
    m_opened = m_model->session().display;
    showNumbers();
  });
  showNumbers();
}

/// Moves all numbers into one row, without the depths below.
void DesignNumbersWidget::arrangeStrip() {
  m_bar->hide();
  m_ui->depthLegend->hide();
  m_ui->designCard->setObjectName("designStrip");
  m_ui->number4->hide();
  int column = 0;
  for (const auto& [cell, width] :
       {std::pair(m_ui->number1, 5), std::pair(m_ui->number2, 6), std::pair(m_ui->number3, 5),
        std::pair(m_ui->number6, 7), std::pair(m_ui->number5, 4)}) {
    cell->setObjectName(QStringLiteral("strip_") + cell->objectName());
    m_ui->cardLayout->setColumnStretch(column, width);
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
  m_bar->update();
  showNumbers();
}

/// Returns zeros if they cannot be worked out.
DesignNumbers DesignNumbersWidget::numbersOf(const DisplayParams& params) const {
  Session session = m_model->session();
  session.display = params;
  if (params.sheet) return {};
  const PanelParams display = withCounts(displayOf(session), m_known);
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
  const DesignNumbers before = isStrip ? numbersOf(m_opened) : DesignNumbers();
  for (const NumberCell& cell : std::initializer_list<NumberCell>{
           {m_ui->number1,
            inDigits(n.hogelPitch, 1000),
            tr("mm"),
            tr("hogel pitch"),
            {},
            changeText(n.hogelPitch[0], before.hogelPitch[0])},
           {m_ui->number2,
            inDigits(n.hogelArcmin),
            tr("arcmin"),
            isStrip ? tr("at the eye") : tr("hogel pitch at the eye"),
            {},
            changeText(n.hogelArcmin[0], before.hogelArcmin[0])},
           {m_ui->number3,
            inDigits(n.degreesPerDirection),
            "°",
            tr("each direction"),
            {},
            changeText(n.degreesPerDirection[0], before.degreesPerDirection[0])},
           {m_ui->number4, inDigits(n.directionsPerPupil), "", tr("directions in the pupil")},
           {m_ui->number5,
            inDigits(n.megapixels),
            tr("Mpx"),
            isStrip ? tr("pixels") : tr("pixels behind lenses"),
            {},
            changeText(n.megapixels, before.megapixels)}})
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
           {m_ui->number5, inDigits(100 * n.pseudoscopic(ipd)), "%", tr("eyes swapped"),
            tr("The share of places of a head from which a flip lies between its eyes, so that "
               "they see their pictures exchanged")}})
    fillCell(cell);
}

void DesignNumbersWidget::showNumbers() {
  const bool isSheet = m_model->session().display.sheet.has_value();
  const std::optional<SheetNumbers> sheet = numbersOfSheet();
  const SharpDepths before = m_bar->sharp;
  setHidden(isSheet && !sheet);
  if (sheet) {
    showSheet(*sheet);
    m_bar->sharp = *sheet;
  } else {
    const DesignNumbers hogels = numbersOf(m_model->session().display);
    showHogels(hogels);
    m_bar->sharp = hogels;
  }
  const SharpDepths& n = m_bar->sharp;
  if (n != before) m_bar->update();
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

void DesignNumbersWidget::resizeEvent(QResizeEvent*) {
  showNumbers();
}

void DesignNumbersWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) showNumbers();
  QWidget::changeEvent(event);
}

}  // namespace hogelscope
