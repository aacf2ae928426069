// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/design_sliders.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "gui/session/session_forms.h"
#include "gui/widgets/colours.h"

namespace hogelscope {

namespace {

constexpr int sliderSteps = 1000;  // of a slider

QToolButton* choice(const char* name, const QString& text, const QString& help, QWidget* row) {
  auto* button = new QToolButton;
  button->setObjectName(name);
  button->setText(text);
  button->setToolTip(help);
  button->setCheckable(true);
  button->setAutoExclusive(true);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  row->layout()->addWidget(button);
  return button;
}

QWidget* choices() {
  auto* row = new QWidget;
  row->setObjectName("designChoices");
  row->setAttribute(Qt::WA_StyledBackground);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(2, 2, 2, 2);
  layout->setSpacing(0);
  return row;
}

}  // namespace

/// A slider with a mark at another design's value.
class DesignSlider : public QSlider {
 public:
  DesignSlider() : QSlider(Qt::Horizontal) {
    setRange(0, sliderSteps);
    setSingleStep(sliderSteps / 100);
    setPageStep(sliderSteps / 10);
  }
  void setMark(std::optional<double> share) {
    m_mark = share;
    update();
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QSlider::paintEvent(event);
    if (!m_mark) return;
    const int handle = scaled(12);
    const int x = handle / 2 + QStyle::sliderPositionFromValue(
                                   0, sliderSteps, int(*m_mark * sliderSteps), width() - handle);
    QPainter(this).fillRect(x - 1, height() / 2 - scaled(6), 2, scaled(12), tokens().text3);
  }
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }  // it scrolls only

 private:
  std::optional<double> m_mark;
};

DesignSliders::DesignSliders(SessionModel* model, QWidget* parent)
    : QWidget(parent), m_model(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(scaled(8));
  column->addWidget(makeDesigns());
  column->addWidget(makeHold());
  m_rows.reserve(designParameters().size());  // rows are referred to
  for (const DesignParameter& parameter : designParameters()) column->addWidget(makeRow(parameter));
  connect(m_model, &SessionModel::opened, this, &DesignSliders::keepOpened);
  onAnyChange(m_model, this, &DesignSliders::follow);
  keepOpened();
}

QWidget* DesignSliders::makeDesigns() {
  QWidget* row = choices();
  m_chooseA = choice("designA", tr("A as opened"), tr("The display as it was opened"), row);
  m_chooseB = choice("designB", tr("B edited"), tr("The display as you edited it"), row);
  connect(m_chooseA, &QToolButton::clicked, this, [this] { choose(m_opened); });
  connect(m_chooseB, &QToolButton::clicked, this, [this] { choose(*m_edited); });
  m_compare = button("compareDesigns", tr("Compare A and B"),
                     tr("Shows the view on display A beside the one on display B"));
  connect(m_compare, &QAbstractButton::clicked, this, [this] { Q_EMIT comparisonAsked(m_opened); });
  return stackWidgets({row, m_compare});
}

QWidget* DesignSliders::makeHold() {
  auto* line = new QWidget;
  auto* layout = new QHBoxLayout(line);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(new QLabel(tr("Hold")));
  QWidget* row = choices();
  layout->addWidget(row, 1);
  const auto add = [&](const char* name, const QString& text, const QString& help, Hold hold) {
    QToolButton* one = choice(name, text, help, row);
    one->setChecked(hold == m_hold);
    connect(one, &QToolButton::clicked, this, [this, hold] { m_hold = hold; });
  };
  add("holdSize", tr("size"), tr("More hogels are smaller"), Hold::size);
  add("holdPitch", tr("pitch"), tr("More hogels make a larger panel"), Hold::pitch);
  add("holdPixels", tr("pixels"),
      tr("More hogels have fewer directions, so that the panel keeps "
         "its number of pixels"),
      Hold::pixels);
  return line;
}

QWidget* DesignSliders::makeRow(const DesignParameter& parameter) {
  auto* widget = new QWidget;
  auto* heading = new QHBoxLayout;
  auto* label = new QLabel(parameter.label);
  m_rows.push_back({parameter, new QLabel, new DesignSlider});
  const Row& row = m_rows.back();
  row.value->setObjectName(QString("design%1Value").arg(parameter.name));
  row.slider->setObjectName(QString("design%1").arg(parameter.name));
  row.slider->setAccessibleName(parameter.label);
  row.slider->setToolTip(tr("%1 … %2; the mark is display A")
                             .arg(parameter.text(parameter.least), parameter.text(parameter.most)));
  heading->addWidget(label);
  heading->addStretch(1);
  heading->addWidget(row.value);
  auto* column = new QVBoxLayout(widget);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(scaled(2));
  column->addLayout(heading);
  column->addWidget(row.slider);
  connect(row.slider, &QSlider::valueChanged, this, [this, &row] { slide(row); });
  connect(row.slider, &QSlider::sliderPressed, this, [this] { m_model->holdEdits(true); });
  connect(row.slider, &QSlider::sliderReleased, this, [this] { m_model->holdEdits(false); });
  return widget;
}

void DesignSliders::keepOpened() {
  m_opened = m_model->session().display;
  m_edited.reset();
  follow();
}

void DesignSliders::choose(const DisplayParams& display) {
  Session content = m_model->session();
  content.display = display;
  m_model->setContent(content);
  follow();  // where nothing changed
}

void DesignSliders::slide(const Row& row) {
  const double value = row.parameter.at(double(row.slider->value()) / sliderSteps);
  m_model->edit(tr("Change %1").arg(row.parameter.label.toLower()), [&](Session& session) {
    session = withValue(session, m_model->currentIndex(), row.parameter, value, m_hold);
  });
}

void DesignSliders::follow() {
  const Session& session = m_model->session();
  setEnabled(!session.cameras.empty());
  if (session.cameras.empty()) return;
  const bool isA = session.display == m_opened;
  if (!isA) m_edited = session.display;
  (isA ? m_chooseA : m_chooseB)->setChecked(true);
  m_chooseB->setEnabled(m_edited.has_value());
  m_compare->setEnabled(m_edited.has_value());
  const std::size_t state = m_model->currentIndex();
  Session opened = session;
  opened.display = m_opened;
  for (const Row& row : m_rows) {
    const double value = row.parameter.get(session, state);
    const double before = row.parameter.get(opened, state);
    const QSignalBlocker quiet(row.slider);
    // A slider that stands for the value stays, so that small sliderSteps between two counts add
    // up.
    if (row.parameter.at(double(row.slider->value()) / sliderSteps) != value)
      row.slider->setValue(int(std::lround(sliderSteps * row.parameter.shareOf(value))));
    row.slider->setMark(before == value ? std::nullopt
                                        : std::optional(row.parameter.shareOf(before)));
    const bool isLeftOut = row.parameter.isWhole && value < 1;
    row.value->setText(isLeftOut ? tr("as the light field") : row.parameter.text(value));
    // The files of a light field fix how many hogels and directions it has.
    row.slider->setEnabled(!row.parameter.isWhole || session.lightField.isLive());
  }
}

}  // namespace hogelscope
