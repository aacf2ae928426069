// SPDX-License-Identifier: BSD-3-Clause
#include "gui/keys/field_guards.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSlider>

namespace hogelscope {

namespace {

bool isText(const QKeyEvent& key) {
  const Qt::KeyboardModifiers others = key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
  return others == Qt::NoModifier && key.key() < Qt::Key_Escape;
}

/// Whether the key moves a slider.
bool isMove(const QKeyEvent& key) {
  const int code = key.key();
  return (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier && code >= Qt::Key_Home &&
         code <= Qt::Key_PageDown;  // with the arrows between them
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

/// Whether a key is kept from the field, or from the shortcuts.
bool filterKey(QObject* watched, QKeyEvent& key) {
  if ((qobject_cast<QComboBox*>(watched) != nullptr && isText(key)) ||
      (qobject_cast<QSlider*>(watched) != nullptr && isMove(key))) {
    key.accept();
    return true;
  }
  const QLineEdit* line = lineOf(watched);
  return line != nullptr && isIdle(*line, key);  // not accepted, so the shortcut is triggered
}

bool isField(const QObject* watched) {
  return qobject_cast<const QAbstractSpinBox*>(watched) != nullptr ||
         qobject_cast<const QComboBox*>(watched) != nullptr;
}

class FieldGuards : public QObject {
 public:
  using QObject::QObject;

 private:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride)
      return filterKey(watched, static_cast<QKeyEvent&>(*event));
    if ((event->type() != QEvent::Wheel && event->type() != QEvent::Show) || !isField(watched))
      return false;
    auto* field = static_cast<QWidget*>(watched);
    if (event->type() == QEvent::Show) {
      if (field->focusPolicy() == Qt::WheelFocus) field->setFocusPolicy(Qt::StrongFocus);
      return false;
    }
    event->setAccepted(field->hasFocus());
    return !field->hasFocus();
  }
};

}  // namespace

void guardFields(QObject* owner) {
  QCoreApplication::instance()->installEventFilter(new FieldGuards(owner));
}

void focusLastField(QWidget* part) {
  const auto isField = [part](const QWidget* each) {
    return part->isAncestorOf(each) && each->isEnabled() && each->isVisibleTo(part) &&
           (each->focusPolicy() & Qt::TabFocus) != 0 &&
           (qobject_cast<const QAbstractSpinBox*>(each) || qobject_cast<const QLineEdit*>(each) ||
            qobject_cast<const QComboBox*>(each) || qobject_cast<const QCheckBox*>(each) ||
            qobject_cast<const QSlider*>(each));
  };
  QWidget* field = part->focusWidget();  // Qt remembers it for each widget, also while hidden
  if (field == nullptr || !isField(field)) {
    field = part->nextInFocusChain();
    while (field != part && !isField(field)) field = field->nextInFocusChain();
  }
  if (field != part) field->setFocus(Qt::TabFocusReason);
}

}  // namespace hogelscope
