// SPDX-License-Identifier: BSD-3-Clause
// A form generated from a parameter description. One visit of the fields shows values in the
// editors, or takes the value that a user changed (only that one, because an editor's rounding must
// not change the others).
#include "gui/widgets/parameter_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>
#include <typeinfo>
#include <vector>

namespace hogelscope {

namespace {

QString toQString(std::string_view text) {
  return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

/// A box for an optional value; empty, one step below the range, means left out.
template <class Box>
class LeavableBox : public Box {
 public:
  using Box::Box;
  using Box::textFromValue;
  using Value = decltype(std::declval<Box>().value());

  [[nodiscard]] Value valueFromText(const QString& text) const override {
    return isEmpty(text) ? this->minimum() : Box::valueFromText(text);
  }
  QValidator::State validate(QString& text, int& position) const override {
    return isEmpty(text) ? QValidator::Acceptable : Box::validate(text, position);
  }
  void mayBeLeftOut() {
    this->setMinimum(this->minimum() - this->singleStep());
    this->setSpecialValueText(QObject::tr("not given"));
  }

 private:
  [[nodiscard]] bool isEmpty(const QString& text) const {
    const QString special = this->specialValueText();
    const QString left = QString(text).remove(this->suffix()).trimmed();
    return !special.isEmpty() && (left.isEmpty() || left == special);
  }
};

/// A box that shows five digits, or the whole integer part; the value keeps more.
class RealBox : public LeavableBox<QDoubleSpinBox> {
 public:
  explicit RealBox(QWidget* parent) : LeavableBox(parent) { setDecimals(12); }
  [[nodiscard]] QString textFromValue(double value) const override {
    const int whole = value == 0 ? 1 : 1 + int(std::floor(std::log10(std::abs(value))));
    return locale().toString(value, 'g', std::max(5, whole));
  }
};

using WholeBox = LeavableBox<QSpinBox>;

}  // namespace

template <class Box>
class BoxRow : public QWidget {
 public:
  using QWidget::QWidget;
  std::vector<Box*> boxes;
};

namespace {

/// Returns the label of a document's name: "Window size" for "windowSize"; names without vowels
/// stay, as "PSF" or "k1".
QString inWords(const QString& name) {
  static const QRegularExpression vowel("[aeiouyAEIOUY]");
  static const QRegularExpression wordEnd("([a-z])([A-Z])");
  if (!name.contains(vowel)) return name.size() < 3 ? name : name.toUpper();
  QString words = QString(name).replace('-', ' ');
  words.replace(wordEnd, "\\1 \\2");
  return words.left(1).toUpper() + words.mid(1).toLower();
}

QString labelOf(const Field& field) {
  return field.label.empty() ? inWords(toQString(field.name)) : toQString(field.label);
}

/// Returns the range of a slider.
Range slideOf(const Range& range) {
  const bool isDeclared = range.slideMin < range.slideMax;
  return {isDeclared ? range.slideMin : range.min, isDeclared ? range.slideMax : range.max,
          range.step};
}

/// Extends the slider's range to a value beyond it.
void growTo(QSlider& slider, const Range& slide, double value) {
  const int at = qRound((value - slide.min) / slide.step);
  slider.setRange(std::min(slider.minimum(), at), std::max(slider.maximum(), at));
}

QString boxName(const Field& field, std::size_t k, bool isList) {
  const QString name = toQString(field.name);
  return isList ? name + "." + QString::number(k) : name;
}

QString textOf(const QWidget* editor) {
  if (const auto* box = qobject_cast<const QAbstractSpinBox*>(editor)) return box->text();
  if (const auto* box = qobject_cast<const QComboBox*>(editor)) return box->currentText();
  if (const auto* line = qobject_cast<const QLineEdit*>(editor)) return line->text();
  const auto* flag = qobject_cast<const QCheckBox*>(editor);
  return flag == nullptr ? QString() : flag->isChecked() ? QObject::tr("on") : QObject::tr("off");
}

double valueInRange(const RealBox& box, const Range& range) {
  return range.mayBeLeftOut && box.value() < range.min ? notGiven : box.value();
}

int valueInRange(const WholeBox& box, const Range& range) {
  if (box.value() < range.min) return box.value();
  return int(range.min + range.step * std::floor((box.value() - range.min) / range.step));
}

}  // namespace

ParameterForm::ParameterForm(Visit visit, Visit defaults, QWidget* parent)
    : QWidget(parent),
      m_visit(std::move(visit)),
      m_defaults(std::move(defaults)),
      m_layout(new QFormLayout(this)),
      m_heading(new QLabel(this)) {
  m_layout->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  m_layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
  m_heading->setObjectName("heading");
  QFont bold = font();
  bold.setBold(true);
  m_heading->setFont(bold);
  m_layout->addRow(m_heading);
  refresh();
}

void ParameterForm::refresh() {
  m_pass = Pass::show;
  m_visited.clear();
  m_visit(*this);
  for (QWidget* row : std::as_const(m_rows))
    if (m_layout->isRowVisible(row) != m_visited.contains(row))
      m_layout->setRowVisible(row, m_visited.contains(row));
}

std::vector<ParameterForm::Row> ParameterForm::rows() const {
  std::vector<Row> rows;
  for (int k = 1; k < m_layout->rowCount(); ++k) {  // below the heading
    if (!m_layout->isRowVisible(k)) continue;
    QWidget* field = m_layout->itemAt(k, QFormLayout::FieldRole)->widget();
    const auto* label = qobject_cast<QLabel*>(m_layout->labelForField(field));
    const auto boxes = field->findChildren<QAbstractSpinBox*>();
    QStringList texts(textOf(field));
    for (const QAbstractSpinBox* box : boxes) texts << textOf(box);
    texts.removeAll({});
    rows.push_back({m_heading->text(), label->text(), boxes.isEmpty() ? field : boxes.front(),
                    texts.join(" × ")});
  }
  return rows;
}

void ParameterForm::hideField(const QString& name, bool isHidden) {
  if (isHidden == m_hidden.contains(name)) return;
  if (isHidden)
    m_hidden.insert(name);
  else
    m_hidden.remove(name);
  refresh();
}

void ParameterForm::slideTo(const QString& name, double most) {
  m_slideMost[name] = most;
  refresh();
}

/// Emits entered() for Return and Escape; editors apply their value and ignore these keys.
void ParameterForm::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key != Qt::Key_Return && key != Qt::Key_Enter && key != Qt::Key_Escape)
    return QWidget::keyPressEvent(event);
  if (key == Qt::Key_Escape) refresh();
  Q_EMIT entered();
}

bool ParameterForm::eventFilter(QObject* watched, QEvent* event) {
  const QString key = watched->property("row").toString();
  if (event->type() != QEvent::ContextMenu || key.isEmpty()) return false;
  const auto& asked = static_cast<const QContextMenuEvent&>(*event);
  showMenu(qobject_cast<QWidget*>(watched), key, asked.globalPos());
  return true;
}

/// Shows the menu: the line edit's own, if any, and the default.
void ParameterForm::showMenu(QWidget* on, const QString& key, const QPoint& at) {
  auto* line = qobject_cast<QLineEdit*>(on);
  QMenu* menu = line != nullptr ? line->createStandardContextMenu() : new QMenu(on);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (line != nullptr) menu->addSeparator();
  offerDefault(menu, key);
  menu->popup(at);
}

void ParameterForm::offerDefault(QMenu* menu, const QString& key) {
  m_default.clear();
  walkDefaults(Pass::sayDefault, key);
  if (m_default.isEmpty()) return;
  QAction* action = menu->addAction(tr("&Default: %1").arg(m_default.join(", ")));
  action->setObjectName("defaultAction");
  connect(action, &QAction::triggered, this, [this, key] {
    walkDefaults(Pass::showDefault, key);
    applyEdit(m_rows[key]);
  });
}

/// Visits the defaults for the row of that key only.
void ParameterForm::walkDefaults(Pass pass, const QString& key) {
  if (!m_defaults) return;
  m_wanted = key;
  m_pass = pass;
  m_defaults(*this);
}

bool ParameterForm::skipsRow(const QWidget* row) const {
  const bool isOfDefaults = m_pass == Pass::sayDefault || m_pass == Pass::showDefault;
  return isOfDefaults && row->property("row").toString() != m_wanted;
}

/// Takes the value of an editor, or of all editors in a row.
void ParameterForm::applyEdit(QObject* editor) {
  m_pass = Pass::apply;
  m_edited = editor;
  m_visit(*this);
  refresh();
}

void ParameterForm::group(std::string_view name, std::string_view help) {
  setObjectName(toQString(name) + "Form");
  m_group = toQString(name);
  m_heading->setText(inWords(m_group));
  setToolTip(toQString(help));
}

/// Returns the field's editor, created by `make` if missing. Fields of one name may have editors of
/// several kinds, and other ranges in another group.
template <class Make>
auto ParameterForm::editor(const Field& field, Make make) -> decltype(make()) {
  using Editor = std::remove_pointer_t<decltype(make())>;
  const QString key = keyOf(field, typeid(Editor).name());
  QWidget*& known = m_rows[key];
  if (known == nullptr) {
    known = make();
    addRow(field, key, known);
  }
  if (field.counts && !m_hidden.contains(toQString(field.name))) m_visited.insert(known);
  return static_cast<Editor*>(known);
}

QString ParameterForm::keyOf(const Field& field, const char* kind) const {
  return m_group + " " + toQString(field.name) + " " + kind;
}

void ParameterForm::addRow(const Field& field, const QString& key, QWidget* editor) {
  auto* label = new QLabel(labelOf(field), this);
  label->setBuddy(editor);
  QList<QWidget*> parts = editor->findChildren<QWidget*>();
  parts << label << editor;
  for (QWidget* part : std::as_const(parts)) {
    part->setProperty("row", key);
    part->installEventFilter(this);
  }
  for (QWidget* widget : {static_cast<QWidget*>(label), editor})
    widget->setToolTip(
        tr("<p>%1</p><p>In documents: <b>%2.%3</b></p>")
            .arg(toQString(field.help).toHtmlEscaped(), m_group, toQString(field.name)));
  m_layout->addRow(label, editor);
}

template <class Box>
BoxRow<Box>* ParameterForm::newBoxes(const Field& field, std::size_t count, bool isList) {
  auto* row = new BoxRow<Box>(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  for (std::size_t k = 0; k < count; ++k) {
    auto* box = new Box(row);
    box->setObjectName(boxName(field, k, isList));
    box->setKeyboardTracking(false);
    const bool isNarrow = count > 2;  // the wheel and the arrow keys still step the value
    if (isNarrow) box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setMinimumWidth(fontMetrics().horizontalAdvance(isNarrow ? "-0.0000 m" : "-00.0000 px") +
                         (isNarrow ? 8 : 24));
    using Value = decltype(box->value());
    box->setRange(Value(field.range.min), Value(field.range.max));
    box->setSingleStep(Value(field.range.step));
    if (!field.unit.empty()) box->setSuffix(" " + toQString(field.unit));
    if (field.range.mayBeLeftOut) box->mayBeLeftOut();
    layout->addWidget(box);
    row->boxes.push_back(box);
    connect(box, &Box::valueChanged, this, [this, box] { applyEdit(box); });
    if (!isList) addSlider(field, box, row);
  }
  return row;
}

/// Adds a slider to a single number whose range has few enough steps.
template <class Box>
void ParameterForm::addSlider(const Field& field, Box* box, QWidget* row) {
  constexpr double mostSteps = 1e5;
  const Range range = slideOf(field.range);
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
  BoxRow<Box>* row = editor(field, [&] { return newBoxes<Box>(field, values.size(), isList); });
  if (skipsRow(row)) return;
  for (std::size_t k = 0; k < values.size(); ++k) {
    Box* box = row->boxes[k];
    if (m_pass == Pass::sayDefault) {
      m_default << (field.range.mayBeLeftOut && values[k] < field.range.min
                        ? box->specialValueText()
                        : box->textFromValue(values[k]) + box->suffix());
      continue;
    }
    if (m_pass == Pass::apply) {
      if (box == m_edited || row == m_edited) values[k] = valueInRange(*box, field.range);
      continue;
    }
    const QSignalBlocker quiet(box);
    box->setValue(values[k]);
    auto* slider = row->template findChild<QSlider*>(boxName(field, k, isList) + ".slider");
    if (slider == nullptr) continue;
    const QSignalBlocker quietSlider(slider);
    // An omitted value is numerically below the range.
    const double shown = std::clamp(double(values[k]), field.range.min, field.range.max);
    const Range slide = slideOf(field.range);
    if (const auto most = m_slideMost.constFind(toQString(field.name)); most != m_slideMost.cend())
      slider->setMaximum(qRound((std::min(*most, field.range.max) - slide.min) / slide.step));
    if (values[k] >= field.range.min) growTo(*slider, slide, shown);
    slider->setValue(qRound((shown - slide.min) / slide.step));
  }
}

void ParameterForm::numbers(const Field& field, std::span<double> values, bool isList) {
  boxes<RealBox>(field, values, isList);
}

void ParameterForm::integers(const Field& field, std::span<int> values, bool isList) {
  boxes<WholeBox>(field, values, isList);
}

void ParameterForm::flag(const Field& field, bool& value) {
  auto* box = editor(field, [this, &field] {
    auto* created = new QCheckBox(this);
    created->setObjectName(toQString(field.name));
    connect(created, &QCheckBox::toggled, this, [this, created] { applyEdit(created); });
    return created;
  });
  if (skipsRow(box)) return;
  if (m_pass == Pass::sayDefault) m_default << (value ? tr("on") : tr("off"));
  if (m_pass == Pass::apply && box == m_edited) value = box->isChecked();
  const QSignalBlocker quiet(box);
  if (shows()) box->setChecked(value);
}

void ParameterForm::text(const Field& field, std::string& value) {
  auto* line = editor(field, [this, &field] {
    auto* created = new QLineEdit(this);
    created->setObjectName(toQString(field.name));
    connect(created, &QLineEdit::editingFinished, this, [this, created] { applyEdit(created); });
    return created;
  });
  if (skipsRow(line)) return;
  if (m_pass == Pass::sayDefault) m_default << "\"" + QString::fromStdString(value) + "\"";
  if (m_pass == Pass::apply && line == m_edited) value = line->text().toStdString();
  const QSignalBlocker quiet(line);
  const QString shown = QString::fromStdString(value);
  if (shows() && line->text() != shown) line->setText(shown);
}

void ParameterForm::choice(const Field& field, int& index) {
  auto* box = editor(field, [this, &field] {
    auto* created = new QComboBox(this);
    created->setObjectName(toQString(field.name));
    for (const std::string_view name : field.choices) created->addItem(toQString(name));
    connect(created, &QComboBox::currentIndexChanged, this,
            [this, created] { applyEdit(created); });
    return created;
  });
  if (skipsRow(box)) return;
  if (m_pass == Pass::sayDefault) m_default << toQString(field.choices[std::size_t(index)]);
  if (m_pass == Pass::apply && box == m_edited) index = box->currentIndex();
  const QSignalBlocker quiet(box);
  if (shows()) box->setCurrentIndex(index);
}

}  // namespace hogelscope
