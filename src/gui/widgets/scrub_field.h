// SPDX-License-Identifier: BSD-3-Clause
// The editor of a number: a spin box without buttons whose value is dragged sideways. It paints
// itself, with a letter and a unit inside and a line that says where the value is in its usual
// range. Its line edit is shown only while the field has the focus.
#pragma once

#include <QDoubleSpinBox>
#include <QHelpEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <type_traits>

#include "core/base/parameters.h"
#include "gui/widgets/colours.h"

namespace hogelscope {

/// A horizontal drag changes the value (Shift: a tenth, Ctrl: ten times as much), a click focuses
/// the field and selects its text, in which the mouse then acts as in any text. The wheel is left
/// to the surroundings.
template <class Box>
class ScrubField : public Box {
 public:
  using Value = decltype(std::declval<Box>().value());

  QString letter;  ///< before the value; x, y and z have the colours of the axes
  QString unit;    ///< at the right; it is no part of the text
  Range usual;     ///< of the line; a drag crosses it in 200 px; no line if it is empty
  std::function<void(bool)> onDrag;  ///< is called when a drag begins (true) and ends

  explicit ScrubField(QWidget* parent) : Box(parent) {
    this->setButtonSymbols(QAbstractSpinBox::NoButtons);
    this->setKeyboardTracking(false);
    this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    this->setFocusPolicy(Qt::TabFocus);  // and a click, when the button is released
    this->setAttribute(Qt::WA_Hover);
    this->setCursor(Qt::SizeHorCursor);
    this->lineEdit()->hide();
    if constexpr (isReal) this->setDecimals(12);
  }

  /// Makes an empty text, one step below the range, mean that the value is left out.
  void mayBeLeftOut() {
    this->setMinimum(this->minimum() - this->singleStep());
    this->setSpecialValueText(QObject::tr("not given"));
  }

  /// Sets the value without a signal, and replaces a text that is being typed. Nothing is done
  /// where the field has the value: Qt rounds it by writing it, which takes long for a form of
  /// fields.
  void showValue(Value value) {
    if (value == m_given && this->value() == m_rounded && this->text() == m_givenText) return;
    const QSignalBlocker quiet(this);
    this->setValue(value);
    m_given = value;
    m_rounded = this->value();
    m_givenText = this->text();
  }

  /// Returns whole numbers as they are, others with five digits or the whole integer part; the
  /// value keeps more.
  [[nodiscard]] QString textFromValue(Value value) const override {
    return inDigits(value, mostDigits);
  }
  /// A text that nobody has changed does not round the value.
  [[nodiscard]] Value valueFromText(const QString& text) const override {
    if (isLeftOut(text)) return this->minimum();
    return text == textFromValue(this->value()) ? this->value() : Box::valueFromText(text);
  }
  QValidator::State validate(QString& text, int& position) const override {
    return isLeftOut(text) ? QValidator::Acceptable : Box::validate(text, position);
  }
  /// Whether the field has room for its text.
  [[nodiscard]] bool isWideEnough() const {
    const auto [text, font] = shown();
    return QFontMetrics(font).horizontalAdvance(text) <= textRect().width();
  }
  [[nodiscard]] QSize sizeHint() const override { return {scaled(54), scaled(24)}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  /// The tooltip begins with the value in all digits, where fewer are shown.
  bool event(QEvent* event) override {
    if (event->type() != QEvent::ToolTip || !isReal || showsLeftOut()) return Box::event(event);
    const QString all =
        this->locale().toString(double(this->value()), 'g', QLocale::FloatingPointShortest);
    if (all == shown().text) return Box::event(event);
    const QWidget* row = this;  // the row has the tooltip of its fields
    while (row->toolTip().isEmpty() && !row->isWindow()) row = row->parentWidget();
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                       "<p><b>" + (all + " " + unit).trimmed() + "</b></p>" + row->toolTip(), this);
    return true;
  }

  void mousePressEvent(QMouseEvent* event) override {
    if (event->button() != Qt::LeftButton) return;
    m_pressed = event->globalPosition().x();
    m_dragged = double(this->value());
  }

  void mouseMoveEvent(QMouseEvent* event) override {
    constexpr double clicks = 3;  // pixels by which a click may move
    const double x = event->globalPosition().x();
    if (!m_pressed || (!m_isDragged && std::abs(x - *m_pressed) < clicks)) return;
    if (!std::exchange(m_isDragged, true) && onDrag) onDrag(true);
    drag(x - *std::exchange(m_pressed, x), event->modifiers());
  }

  void mouseReleaseEvent(QMouseEvent* event) override {
    if (event->button() != Qt::LeftButton || !m_pressed) return;
    m_pressed.reset();
    if (std::exchange(m_isDragged, false)) {
      if (onDrag) onDrag(false);
      return;
    }
    this->setFocus(Qt::MouseFocusReason);
    this->selectAll();
  }

  void wheelEvent(QWheelEvent* event) override { event->ignore(); }

  void focusInEvent(QFocusEvent* event) override {
    const QRect text = textRect();
    this->lineEdit()->setTextMargins(text.left() - 3, 0, this->width() - text.right() - 4, 0);
    this->lineEdit()->show();
    Box::focusInEvent(event);
  }

  void focusOutEvent(QFocusEvent* event) override {
    Box::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason) this->lineEdit()->hide();
  }

  void paintEvent(QPaintEvent* /*event*/) override {
    const Tokens& t = tokens();
    const bool isFocused = this->hasFocus();
    const bool isHovered = this->isEnabled() && this->underMouse() && !isFocused;
    const double ring = isFocused ? 2 : 1;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath frame;
    frame.addRoundedRect(QRectF(this->rect()).marginsRemoved(QMarginsF(1, 1, 1, 1) * (ring / 2)), 4,
                         4);
    painter.fillPath(frame, isHovered ? t.hover : t.field);
    if (usual.min < usual.max) {
      const double share = (double(this->value()) - usual.min) / (usual.max - usual.min);
      painter.setClipPath(frame);
      painter.fillRect(QRectF(ring, this->height() - ring - 2,
                              std::clamp(share, 0.0, 1.0) * (this->width() - 2 * ring), 2),
                       isFocused || isHovered ? t.focus : t.strongLine);
      painter.setClipping(false);
    }
    painter.strokePath(frame, QPen(isFocused ? t.focus : t.line, ring));
    const QRect inside = this->rect().adjusted(scaled(6), 0, -scaled(6), 0);
    const qsizetype axis = QString("xyz").indexOf(letter);
    writeLine(painter, inside, Qt::AlignVCenter, letter, letterFont(),
              axis < 0 ? t.text3 : t.axes[std::size_t(axis)]);
    writeLine(painter, inside, Qt::AlignVCenter | Qt::AlignRight, unit, unitFont(), t.text3);
    if (isFocused) return;
    const auto [text, font] = shown();
    writeLine(painter, textRect(), Qt::AlignVCenter, text, font,
              this->isEnabled() && !showsLeftOut() ? t.text : t.text3);
  }

 private:
  static constexpr bool isReal = std::is_same_v<Value, double>;
  static constexpr int mostDigits = 5;
  static constexpr int leastDigits = 3;

  static QFont letterFont() { return textFont(TextSize::caption, QFont::DemiBold); }
  static QFont unitFont() { return textFont(TextSize::caption); }

  [[nodiscard]] QString inDigits(Value value, int digits) const {
    if constexpr (isReal) {
      const int whole = value == 0 ? 1 : 1 + int(std::floor(std::log10(std::abs(value))));
      return this->locale().toString(value, 'g', std::max(digits, whole));
    }
    return Box::textFromValue(int(value));
  }

  [[nodiscard]] bool showsLeftOut() const {
    return !this->specialValueText().isEmpty() && this->value() == this->minimum();
  }

  /// The special text may be a number, which is left out only while it is shown as that.
  [[nodiscard]] bool isLeftOut(const QString& text) const {
    const QString special = this->specialValueText();
    return !special.isEmpty() &&
           (text.trimmed().isEmpty() || (text.trimmed() == special && showsLeftOut()));
  }

  /// Whole numbers keep to their steps, others are rounded to a step, or with Shift a tenth of it.
  void drag(double pixels, Qt::KeyboardModifiers keys) {
    constexpr double crossing = 200;  // pixels across the usual range
    const bool isFine = keys.testFlag(Qt::ShiftModifier);
    const double factor = isFine ? 0.1 : keys.testFlag(Qt::ControlModifier) ? 10 : 1;
    const double step = this->singleStep();
    const double perPixel = usual.min < usual.max ? (usual.max - usual.min) / crossing : step;
    const double least = this->minimum();
    m_dragged = std::clamp(m_dragged + factor * perPixel * pixels, least, double(this->maximum()));
    const double grid = isReal && isFine ? step / 10 : step;
    const double from = isReal ? 0 : least;
    this->setValue(Value(from + grid * std::round((m_dragged - from) / grid)));
  }

  [[nodiscard]] QRect textRect() const {
    const auto width = [](const QString& text, const QFont& font) {
      return text.isEmpty() ? 0 : QFontMetrics(font).horizontalAdvance(text) + scaled(4);
    };
    return this->rect().adjusted(scaled(6) + width(letter, letterFont()), 2,
                                 -scaled(6) - width(unit, unitFont()), -2);
  }

  struct Shown {
    QString text;
    QFont font;
  };

  /// Returns what fits: the text, or as it is too wide with fewer digits, but at least three, or in
  /// smaller letters.
  [[nodiscard]] Shown shown() const {
    const int width = textRect().width();
    const auto fits = [width](const Shown& shown) {
      return QFontMetrics(shown.font).horizontalAdvance(shown.text) <= width;
    };
    Shown shown{this->text(), this->font()};
    const bool hasDigits = isReal && !showsLeftOut();
    for (int digits = mostDigits - 1; digits >= leastDigits && hasDigits && !fits(shown); --digits)
      shown.text = inDigits(this->value(), digits);
    if (!fits(shown)) shown.font = textFont(TextSize::caption);
    if (!fits(shown)) shown.font.setPixelSize(shown.font.pixelSize() * 5 / 6);
    return shown;
  }

  std::optional<Value> m_given;     ///< by showValue()
  Value m_rounded{};                ///< what Qt made of it
  QString m_givenText;              ///< of the line edit then
  std::optional<double> m_pressed;  ///< where the mouse was last, on the screen
  double m_dragged = 0;             ///< the value of the drag, before it is rounded
  bool m_isDragged = false;
};

using RealField = ScrubField<QDoubleSpinBox>;
using WholeField = ScrubField<QSpinBox>;

}  // namespace hogelscope
