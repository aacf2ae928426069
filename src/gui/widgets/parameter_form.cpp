// SPDX-License-Identifier: BSD-3-Clause
// A form generated from a parameter description. One visit of the fields shows values in the
// editors, or takes the value that a user changed (only that one, because an editor's rounding must
// not change the others).
#include "gui/widgets/parameter_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "core/base/text.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/scrub_field.h"

namespace hogelscope {

namespace {

QString toQString(std::string_view text) {
  return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

}  // namespace

template <class Box>
class BoxRow : public QWidget {
 public:
  using QWidget::QWidget;
  std::vector<Box*> boxes;
  std::vector<double> defaults;
  QString defaultText;  ///< of the defaults
};

/// A field's name, with the unit of all of its numbers, and before it the dot of a value that is
/// not the default.
class FieldLabel : public QLabel {
 public:
  FieldLabel(const QString& name, const QString& unit, QWidget* parent)
      : QLabel(QString("%1 <span style='font-size: %2px'>%3</span>")
                   .arg(name)
                   .arg(textFont(TextSize::caption).pixelSize())
                   .arg(unit),
               parent) {
    setAccessibleName(name);
    setWordWrap(true);
    setContentsMargins(scaled(12), 0, 0, 0);
  }

  /// All labels have one width, hence one height. QFormLayout would keep the heights of rows that
  /// have depended on widths after it has shown or hidden others (seen with Qt 6.4).
  [[nodiscard]] bool hasHeightForWidth() const override { return false; }
  [[nodiscard]] QSize sizeHint() const override {
    const int width = scaled(104);
    return {width, std::max(scaled(24), heightForWidth(width))};
  }
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

  std::function<void()> reset;  ///< is called for a click on the dot
  QString defaultText;          ///< empty if there is no default
  bool isDotted = false;

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override {
    if (isDotted && event->button() == Qt::LeftButton && event->pos().x() < scaled(12)) reset();
  }

  void paintEvent(QPaintEvent* event) override {
    QLabel::paintEvent(event);
    if (!isDotted) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tokens().focus);
    painter.drawEllipse(QPointF(scaled(6), height() / 2.0), 2.5, 2.5);
  }
};

namespace {

QString labelTextOf(const Field& field) {
  return toQString(field.label.empty() ? formLabel(field.name) : std::string(field.label));
}

/// How a field's numbers are shown: lengths that are usually small in millimetres or micrometres.
struct ShownUnit {
  QString text;
  double factor = 1;  ///< shown number per number of the field

  [[nodiscard]] Range range(Range range) const {
    for (double* value : {&range.min, &range.max, &range.step, &range.slideMin, &range.slideMax})
      *value *= factor;
    return range;
  }
};

ShownUnit shownUnit(const Field& field) {
  const Range& range = field.range;
  const double most = range.slideMin < range.slideMax ? range.slideMax : range.max;
  for (const auto& [text, factor] : {std::pair("mm", 1e3), std::pair("µm", 1e6)})
    if (field.unit == "m" && most < 0.5 && most * factor >= 1) return {text, factor};
  return {toQString(field.unit)};
}

/// Returns the allowed values in words; nothing where they are as good as all.
QString rangeText(const Range& range, const QString& unit) {
  if (!(range.min < range.max) || range.max >= 1e6) return {};
  const QLocale locale;
  return QString("%1 … %2 %3").arg(locale.toString(range.min), locale.toString(range.max), unit);
}

/// Returns the range that people use; empty if it has too many steps to be seen.
Range usualOf(const Range& range) {
  constexpr double mostSteps = 1e5;
  const Range usual =
      range.slideMin < range.slideMax ? Range{range.slideMin, range.slideMax} : range;
  return (usual.max - usual.min) / range.step > mostSteps ? Range{} : usual;
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

double valueInRange(const RealField& box, const Range& range) {
  return range.mayBeLeftOut && box.value() < range.min ? notGiven : box.value();
}

int valueInRange(const WholeField& box, const Range& range) {
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
  m_layout->setContentsMargins(0, scaled(4), scaled(12), scaled(4));
  m_layout->setHorizontalSpacing(0);
  m_layout->setVerticalSpacing(scaled(4));
  m_heading->setObjectName("heading");
  m_layout->addRow(m_heading);
  refresh();
}

/// A field that loses the focus says what was typed into it, also when it is deleted.
ParameterForm::~ParameterForm() {
  for (QWidget* field : findChildren<QWidget*>()) field->blockSignals(true);
}

void ParameterForm::refresh() {
  m_pass = Pass::show;
  m_visited.clear();
  m_visit(*this);
  for (QWidget* row : std::as_const(m_rows))
    if (m_layout->isRowVisible(row) != m_visited.contains(row))
      m_layout->setRowVisible(row, m_visited.contains(row));
  walkDefaults(Pass::compare);
}

void ParameterForm::hideHeading() {
  m_layout->setRowVisible(m_heading, false);
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
    rows.push_back({m_heading->text(), label->accessibleName(),
                    boxes.isEmpty() ? field : boxes.front(), texts.join(" × ")});
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

void ParameterForm::showLeftOut(const QString& editor, const QString& text) {
  auto* box = findChild<QAbstractSpinBox*>(editor);
  if (box == nullptr || box->specialValueText().isEmpty()) return;
  box->setSpecialValueText(text.isEmpty() ? tr("not given") : text);
}

QToolButton* ParameterForm::addButton(const QString& pair, const QString& name, bool isOn,
                                      const QString& help) {
  auto* button = new QToolButton;
  button->setObjectName(pair + "." + name);
  button->setToolTip(help);
  button->setAccessibleName(help);
  button->setCheckable(true);
  button->setFixedSize(scaled(20), scaled(24));
  const auto show = [button, name] {
    button->setIcon(icon(button->isChecked() ? name : "un" + name));
  };
  connect(button, &QToolButton::toggled, this, show);
  button->setChecked(isOn);
  show();
  QLayout* row = findChild<QWidget*>(pair + ".0")->parentWidget()->layout();
  QWidget* last = row->itemAt(row->count() - 1)->widget();
  row->addWidget(button);
  setTabOrder(last, button);
  return button;
}

void ParameterForm::linkPair(const QString& name, bool isOn) {
  for (const auto& [part, letter] : {std::pair(".0", "h"), std::pair(".1", "v")}) {
    auto* box = findChild<QWidget*>(name + part);
    if (auto* real = dynamic_cast<RealField*>(box)) real->letter = letter;
    if (auto* whole = dynamic_cast<WholeField*>(box)) whole->letter = letter;
  }
  m_links[name] = {
      addButton(name, "link", isOn, tr("Linked: a change of one changes the other in proportion"))};
}

/// Return applies the value, which the editors do themselves, and keeps the focus.
void ParameterForm::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) return;
  if (key != Qt::Key_Escape) return QWidget::keyPressEvent(event);
  refresh();
  Q_EMIT escaped();
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
  if (line == nullptr && on->inherits("QAbstractSpinBox")) line = on->findChild<QLineEdit*>();
  QMenu* menu = line != nullptr ? line->createStandardContextMenu() : new QMenu(on);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (line != nullptr) menu->addSeparator();
  if (const QString words = labelOf(m_rows[key])->defaultText; !words.isEmpty()) {
    QAction* action =
        menu->addAction(tr("&Default: %1").arg(words), this, [this, key] { reset(key); });
    action->setObjectName("defaultAction");
  }
  menu->popup(at);
}

void ParameterForm::reset(const QString& key) {
  m_wanted = key;
  walkDefaults(Pass::showDefault);
  applyEdit(m_rows[key]);
}

/// Visits the defaults: compares all with what is shown, or shows that of the wanted row.
void ParameterForm::walkDefaults(Pass pass) {
  m_pass = pass;
  if (m_defaults) m_defaults(*this);
}

/// Defaults make no rows.
bool ParameterForm::skipsRow(const QWidget* row) const {
  return row == nullptr ||
         (m_pass == Pass::showDefault && row->property("row").toString() != m_wanted);
}

FieldLabel* ParameterForm::labelOf(QWidget* row) const {
  return static_cast<FieldLabel*>(m_layout->labelForField(row));
}

/// Takes a row's default, in words, and whether it is what the row shows.
void ParameterForm::takeDefault(const Field& field, QWidget* row, const QString& words,
                                bool isShown) {
  FieldLabel* label = labelOf(row);
  if (std::exchange(label->isDotted, !isShown) == isShown) label->update();
  if (std::exchange(label->defaultText, words) != words) explain(field, row);
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
  m_heading->setText(toQString(formLabel(name.substr(name.rfind('.') + 1))));
  setToolTip(toQString(help));
}

/// Returns the field's editor, created by `make` if missing, but not by defaults. Fields of one
/// name may have editors of several kinds, and other ranges in another group or with another label.
template <class Make>
auto ParameterForm::editor(const Field& field, Make make) -> decltype(make()) {
  using Editor = std::remove_pointer_t<decltype(make())>;
  const QString key = keyOf(field, typeid(Editor).name());
  if (m_pass >= Pass::compare) return static_cast<Editor*>(m_rows.value(key));
  QWidget*& known = m_rows[key];
  if (known == nullptr) {
    known = make();
    addRow(field, key, known);
  }
  if (field.counts && !m_hidden.contains(toQString(field.name))) m_visited.insert(known);
  return static_cast<Editor*>(known);
}

QString ParameterForm::keyOf(const Field& field, const char* kind) const {
  return m_group + " " + toQString(field.name) + " " + toQString(field.label) + " " + kind;
}

void ParameterForm::addRow(const Field& field, const QString& key, QWidget* editor) {
  const bool isList = editor->findChildren<QAbstractSpinBox*>().size() > 1;
  auto* label =
      new FieldLabel(labelTextOf(field), isList ? shownUnit(field).text : QString(), this);
  label->setBuddy(editor);
  label->reset = [this, key] { reset(key); };
  QList<QWidget*> parts = editor->findChildren<QWidget*>();
  parts << label << editor;
  for (QWidget* part : std::as_const(parts)) {
    part->setProperty("row", key);
    part->installEventFilter(this);
  }
  m_layout->addRow(label, editor);
  explain(field, editor);
}

/// Sets a row's tooltip: meaning, range, default, name in documents.
void ParameterForm::explain(const Field& field, QWidget* row) {
  FieldLabel* label = labelOf(row);
  const ShownUnit unit = shownUnit(field);
  QStringList values{rangeText(unit.range(field.range), unit.text)};
  if (!label->defaultText.isEmpty()) values << tr("default %1").arg(label->defaultText);
  values.removeAll({});
  const QString tip = QString("<p><b>%1</b><br>%2</p><p>%3<br>%4.%5</p>")
                          .arg(labelTextOf(field), toQString(field.help).toHtmlEscaped(),
                               values.join(", ").toHtmlEscaped(), m_group, toQString(field.name));
  row->setToolTip(tip);
  label->setToolTip(tip);
}

template <class Box>
BoxRow<Box>* ParameterForm::newBoxes(const Field& field, std::size_t count, bool isList) {
  auto* row = new BoxRow<Box>(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(scaled(4));
  // Three numbers are a place, a direction, or those of the three colours, as the help says.
  const bool areColours = field.help.find("red, green") != std::string_view::npos;
  const QString letters = areColours ? "rgb" : field.range.min < 0 ? "xyz" : "";
  const ShownUnit unit = shownUnit(field);
  const Range range = unit.range(field.range);
  for (std::size_t k = 0; k < count; ++k) {
    auto* box = new Box(row);
    box->setObjectName(boxName(field, k, isList));
    using Value = typename Box::Value;
    box->setRange(Value(range.min), Value(range.max));
    box->setSingleStep(Value(range.step));
    if (count == 3) box->letter = letters.mid(qsizetype(k), 1);
    if (count == 1) box->unit = unit.text;
    box->usual = usualOf(range);
    box->setAccessibleName(
        QStringList({labelTextOf(field), count > 1 ? QString::number(k + 1) : "", unit.text})
            .join(' ')
            .simplified());
    if (field.range.mayBeLeftOut) box->mayBeLeftOut();
    layout->addWidget(box);
    row->boxes.push_back(box);
    connect(box, &Box::valueChanged, this, [this, box] { applyEdit(box); });
    box->onDrag = [this](bool isHeld) { Q_EMIT dragged(isHeld); };
  }
  return row;
}

template <class Box, class Number>
void ParameterForm::boxes(const Field& field, std::span<Number> values, bool isList) {
  BoxRow<Box>* row = editor(field, [&] { return newBoxes<Box>(field, values.size(), isList); });
  if (skipsRow(row)) return;
  if (m_pass == Pass::compare) return compareBoxes<Box, Number>(field, row, values);
  const std::vector<Number> before(values.begin(), values.end());
  const ShownUnit unit = shownUnit(field);
  const Range range = unit.range(field.range);
  for (std::size_t k = 0; k < values.size(); ++k) {
    Box* box = row->boxes[k];
    const Number shown = unit.factor == 1 ? values[k] : Number(unit.factor * values[k]);
    if (m_pass == Pass::apply) {
      if (box == m_edited || row == m_edited)
        values[k] = Number(valueInRange(*box, range) / unit.factor);
      const auto link = m_links.find(toQString(field.name));
      if (box == m_edited && values[k] != before[k] && link != m_links.end() &&
          link->button->isChecked())
        link->pair.follow(field.range, std::span<const Number>(before), values);
    } else {
      box->showValue(shown);
    }
  }
}

template <class Box, class Number>
void ParameterForm::compareBoxes(const Field& field, BoxRow<Box>* row,
                                 std::span<const Number> defaults) {
  const ShownUnit unit = shownUnit(field);
  const Range range = unit.range(field.range);
  const auto isGiven = [&](Number value) {
    return !field.range.mayBeLeftOut || value >= field.range.min;
  };
  bool isShown = true;
  QStringList words;
  const bool areKnown =
      std::ranges::all_of(defaults, isGiven) && std::ranges::equal(row->defaults, defaults);
  for (std::size_t k = 0; k < defaults.size(); ++k) {
    const Box* box = row->boxes[k];
    const Number number = unit.factor == 1 ? defaults[k] : Number(unit.factor * defaults[k]);
    isShown &= isGiven(defaults[k]) ? std::abs(double(box->value()) - double(number)) < 1e-12
                                    : box->value() < range.min;
    if (!areKnown)  // to write numbers takes long
      words << (isGiven(defaults[k]) ? (box->textFromValue(number) + " " + unit.text).trimmed()
                                     : box->specialValueText());
  }
  if (!areKnown) {
    row->defaults.assign(defaults.begin(), defaults.end());
    row->defaultText = words.join(", ");
  }
  takeDefault(field, row, row->defaultText, isShown);
}

void ParameterForm::numbers(const Field& field, std::span<double> values, bool isList) {
  boxes<RealField>(field, values, isList);
}

void ParameterForm::integers(const Field& field, std::span<int> values, bool isList) {
  boxes<WholeField>(field, values, isList);
}

void ParameterForm::flag(const Field& field, bool& value) {
  auto* box = editor(field, [this, &field] {
    auto* created = new QCheckBox(this);
    created->setObjectName(toQString(field.name));
    connect(created, &QCheckBox::toggled, this, [this, created] { applyEdit(created); });
    return created;
  });
  if (skipsRow(box)) return;
  if (m_pass == Pass::compare)
    takeDefault(field, box, value ? tr("on") : tr("off"), box->isChecked() == value);
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
  if (m_pass == Pass::compare)  // an empty name is no value to go back to
    takeDefault(field, line, "\"" + QString::fromStdString(value) + "\"",
                value.empty() || value == line->text().toStdString());
  if (m_pass == Pass::apply && line == m_edited) value = line->text().toStdString();
  const QSignalBlocker quiet(line);
  const QString shown = QString::fromStdString(value);
  if (shows() && line->text() != shown) line->setText(shown);
}

void ParameterForm::choice(const Field& field, int& index) {
  auto* box = editor(field, [this, &field] {
    auto* created = new QComboBox(this);
    created->setObjectName(toQString(field.name));
    created->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    created->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    created->setMinimumHeight(scaled(24));
    for (const std::string_view name : field.choices) created->addItem(toQString(name));
    connect(created, &QComboBox::currentIndexChanged, this,
            [this, created] { applyEdit(created); });
    return created;
  });
  if (skipsRow(box)) return;
  if (m_pass == Pass::compare)
    takeDefault(field, box, toQString(field.choices[std::size_t(index)]),
                box->currentIndex() == index);
  if (m_pass == Pass::apply && box == m_edited) index = box->currentIndex();
  const QSignalBlocker quiet(box);
  if (shows()) box->setCurrentIndex(index);
}

}  // namespace hogelscope
