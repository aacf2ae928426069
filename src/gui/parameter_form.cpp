// SPDX-License-Identifier: BSD-3-Clause
// A form made from a parameter description. One walk over the fields builds the editors, shows
// values in them, or takes the one that a user changed (only that one: an editor's rounding must
// not touch the others).
#include "gui/parameter_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

namespace hogelscope {

namespace {

QString toQString(std::string_view text) {
  return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

/// Shows as many digits as the value has, not a fixed number. Where a value may be left out, the
/// emptied box, one step below the range, stands for that.
class RealBox : public QDoubleSpinBox {
 public:
  explicit RealBox(QWidget* parent) : QDoubleSpinBox(parent) { setDecimals(12); }
  [[nodiscard]] QString textFromValue(double value) const override {
    return locale().toString(value, 'g', 9);
  }
  [[nodiscard]] double valueFromText(const QString& text) const override {
    return isEmpty(text) ? minimum() : QDoubleSpinBox::valueFromText(text);
  }
  QValidator::State validate(QString& text, int& position) const override {
    return isEmpty(text) ? QValidator::Acceptable : QDoubleSpinBox::validate(text, position);
  }
  void mayBeLeftOut() {
    setMinimum(minimum() - singleStep());
    setSpecialValueText(QObject::tr("not given"));
  }

 private:
  [[nodiscard]] bool isEmpty(const QString& text) const {
    const QString left = QString(text).remove(suffix()).trimmed();
    return !specialValueText().isEmpty() && (left.isEmpty() || left == specialValueText());
  }
};

QString boxName(const Field& field, std::size_t k, bool isList) {
  const QString name = toQString(field.name);
  return isList ? name + "." + QString::number(k) : name;
}

double taken(const RealBox& box, const Range& range) {
  return range.mayBeLeftOut && box.value() < range.min ? notGiven : box.value();
}

int taken(const QSpinBox& box, const Range& range) {
  return int(range.min + range.step * std::floor((box.value() - range.min) / range.step));
}

}  // namespace

ParameterForm::ParameterForm(Visit visit, QWidget* parent)
    : QWidget(parent), m_visit(std::move(visit)), m_layout(new QFormLayout(this)) {
  m_layout->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  m_visit(*this);
  refresh();
}

void ParameterForm::refresh() {
  m_pass = Pass::show;
  m_visit(*this);
}

void ParameterForm::take(QObject* editor) {
  m_pass = Pass::take;
  m_taken = editor;
  m_visit(*this);
  refresh();
}

void ParameterForm::group(std::string_view name, std::string_view help) {
  setObjectName(toQString(name) + "Form");
  setToolTip(toQString(help));
}

void ParameterForm::addRow(const Field& field, QWidget* editor) {
  auto* label = new QLabel(toQString(field.name), this);
  label->setBuddy(editor);
  for (QWidget* widget : {static_cast<QWidget*>(label), editor})
    widget->setToolTip(toQString(field.help));
  m_layout->addRow(label, editor);
}

template <class Box>
void ParameterForm::addBoxes(const Field& field, std::size_t count, bool isList) {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  for (std::size_t k = 0; k < count; ++k) {
    auto* box = new Box(row);
    box->setObjectName(boxName(field, k, isList));
    box->setKeyboardTracking(false);
    box->setMinimumWidth(fontMetrics().horizontalAdvance("-00.0000 px") + 24);
    using Value = decltype(box->value());
    box->setRange(Value(field.range.min), Value(field.range.max));
    box->setSingleStep(Value(field.range.step));
    if (!field.unit.empty()) box->setSuffix(" " + toQString(field.unit));
    if constexpr (std::is_same_v<Box, RealBox>)
      if (field.range.mayBeLeftOut) box->mayBeLeftOut();
    layout->addWidget(box);
    connect(box, &Box::valueChanged, this, [this, box] { take(box); });
    if (!isList) addSlider(field, box, row);
  }
  addRow(field, row);
}

/// Beside a single number whose range has few enough steps to be slid over.
template <class Box>
void ParameterForm::addSlider(const Field& field, Box* box, QWidget* row) {
  constexpr double mostSteps = 1e5;
  const Range range = field.range;
  const double steps = (range.max - range.min) / range.step;
  if (steps > mostSteps) return;
  auto* slider = new QSlider(Qt::Horizontal, row);
  slider->setObjectName(boxName(field, 0, false) + ".slider");
  slider->setRange(0, qRound(steps));
  slider->setPageStep(std::max(1, qRound(steps / 20)));
  row->layout()->addWidget(slider);
  using Value = decltype(box->value());
  connect(slider, &QSlider::valueChanged, box,
          [box, range](int at) { box->setValue(Value(range.min + range.step * at)); });
}

template <class Box, class Number>
void ParameterForm::boxes(const Field& field, std::span<Number> values, bool isList) {
  if (m_pass == Pass::build) return addBoxes<Box>(field, values.size(), isList);
  for (std::size_t k = 0; k < values.size(); ++k) {
    auto* box = findChild<Box*>(boxName(field, k, isList));
    if (m_pass == Pass::take) {
      if (box == m_taken) values[k] = taken(*box, field.range);
      continue;
    }
    const QSignalBlocker quiet(box);
    box->setValue(values[k]);
    auto* slider = findChild<QSlider*>(boxName(field, k, isList) + ".slider");
    if (slider == nullptr) continue;
    const QSignalBlocker quietSlider(slider);
    slider->setValue(qRound((values[k] - field.range.min) / field.range.step));
  }
}

void ParameterForm::numbers(const Field& field, std::span<double> values, bool isList) {
  boxes<RealBox>(field, values, isList);
}

void ParameterForm::integers(const Field& field, std::span<int> values, bool isList) {
  boxes<QSpinBox>(field, values, isList);
}

void ParameterForm::flag(const Field& field, bool& value) {
  if (m_pass == Pass::build) {
    auto* box = new QCheckBox(this);
    box->setObjectName(toQString(field.name));
    connect(box, &QCheckBox::toggled, this, [this, box] { take(box); });
    return addRow(field, box);
  }
  auto* box = findChild<QCheckBox*>(toQString(field.name));
  if (m_pass == Pass::take && box == m_taken) value = box->isChecked();
  const QSignalBlocker quiet(box);
  if (m_pass == Pass::show) box->setChecked(value);
}

void ParameterForm::text(const Field& field, std::string& value) {
  if (m_pass == Pass::build) {
    auto* line = new QLineEdit(this);
    line->setObjectName(toQString(field.name));
    connect(line, &QLineEdit::editingFinished, this, [this, line] { take(line); });
    return addRow(field, line);
  }
  auto* line = findChild<QLineEdit*>(toQString(field.name));
  if (m_pass == Pass::take && line == m_taken) value = line->text().toStdString();
  const QSignalBlocker quiet(line);
  if (m_pass == Pass::show) line->setText(QString::fromStdString(value));
}

void ParameterForm::choice(const Field& field, int& index) {
  if (m_pass == Pass::build) {
    auto* box = new QComboBox(this);
    box->setObjectName(toQString(field.name));
    for (const std::string_view name : field.choices) box->addItem(toQString(name));
    connect(box, &QComboBox::currentIndexChanged, this, [this, box] { take(box); });
    return addRow(field, box);
  }
  auto* box = findChild<QComboBox*>(toQString(field.name));
  if (m_pass == Pass::take && box == m_taken) index = box->currentIndex();
  const QSignalBlocker quiet(box);
  if (m_pass == Pass::show) box->setCurrentIndex(index);
}

}  // namespace hogelscope
