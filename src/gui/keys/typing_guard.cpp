// SPDX-License-Identifier: BSD-3-Clause
#include "gui/keys/typing_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>

namespace hogelscope {

namespace {

bool isText(const QKeyEvent& key) {
  const Qt::KeyboardModifiers others = key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
  return others == Qt::NoModifier && key.key() < Qt::Key_Escape;
}

/// Returns the line edit itself, or the one in a spin box.
const QLineEdit* lineOf(const QObject* watched) {
  const auto* line = qobject_cast<const QLineEdit*>(watched);
  if (line == nullptr && qobject_cast<const QAbstractSpinBox*>(watched) != nullptr)
    line = watched->findChild<const QLineEdit*>();
  return line;
}

/// Whether the key is undo or redo, and the field has nothing to undo or redo.
bool isIdle(const QLineEdit& line, const QKeyEvent& key) {
  return (key.matches(QKeySequence::Undo) && !line.isUndoAvailable()) ||
         (key.matches(QKeySequence::Redo) && !line.isRedoAvailable());
}

}  // namespace

TypingGuard::TypingGuard(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool TypingGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (qobject_cast<QComboBox*>(watched) != nullptr && isText(key)) {
    event->accept();
    return true;
  }
  const QLineEdit* line = lineOf(watched);
  return line != nullptr && isIdle(*line, key);  // not accepted, so the shortcut is triggered
}

}  // namespace hogelscope
