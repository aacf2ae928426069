// SPDX-License-Identifier: BSD-3-Clause
// The wheel over input fields.
#include "gui/keys/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QSlider>

namespace hogelscope {

namespace {

bool isField(const QObject* watched) {
  return qobject_cast<const QAbstractSpinBox*>(watched) != nullptr ||
         qobject_cast<const QComboBox*>(watched) != nullptr ||
         qobject_cast<const QSlider*>(watched) != nullptr;
}

}  // namespace

WheelGuard::WheelGuard(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
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

}  // namespace hogelscope
