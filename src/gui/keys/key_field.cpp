// SPDX-License-Identifier: BSD-3-Clause
#include "gui/keys/key_field.h"

#include <QKeyEvent>
#include <array>

namespace hogelscope {

namespace {

bool isTaken(const QKeyEvent& event) {
  constexpr std::array<int, 5> kept{Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_Escape, Qt::Key_Return,
                                    Qt::Key_Enter};
  return std::ranges::find(kept, event.key()) == kept.end();
}

/// Whether the key is a modifier, such as Shift or Ctrl alone.
bool isModifier(int key) {
  return (key >= Qt::Key_Shift && key <= Qt::Key_ScrollLock) || key == Qt::Key_AltGr ||
         key == Qt::Key_Super_L || key == Qt::Key_Super_R || key == Qt::Key_unknown || key == 0;
}

/// Returns the modifiers. Shift that is needed to type a sign, such as +, is part of the sign.
Qt::KeyboardModifiers modifiersOf(const QKeyEvent& event) {
  Qt::KeyboardModifiers modifiers = event.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier |
                                                         Qt::AltModifier | Qt::MetaModifier);
  const bool isSign = event.key() < Qt::Key_Escape && event.key() != Qt::Key_Space &&
                      !QChar(event.key()).isLetterOrNumber();
  if (isSign) modifiers &= ~Qt::KeyboardModifiers(Qt::ShiftModifier);
  return modifiers;
}

}  // namespace

KeyField::KeyField(QWidget* parent) : QLineEdit(parent) {
  setReadOnly(true);
  setContextMenuPolicy(Qt::NoContextMenu);
  setAttribute(Qt::WA_InputMethodEnabled, false);
}

bool KeyField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isTaken(static_cast<QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

void KeyField::keyPressEvent(QKeyEvent* event) {
  if (!isTaken(*event)) {
    event->ignore();
    return;
  }
  if (isModifier(event->key())) return;
  const Qt::KeyboardModifiers modifiers = modifiersOf(*event);
  const bool isRemoved = modifiers == Qt::NoModifier &&
                         (event->key() == Qt::Key_Backspace || event->key() == Qt::Key_Delete);
  Q_EMIT keyPressed(isRemoved ? QKeySequence()
                              : QKeySequence(QKeyCombination(modifiers, Qt::Key(event->key()))));
}

}  // namespace hogelscope
