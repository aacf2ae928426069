// SPDX-License-Identifier: BSD-3-Clause
// Acts on the window's fields for numbers, and reads their lines.
#pragma once

#include <QMouseEvent>
#include <QtTest>

#include "gui/widgets/colours.h"

/// Drags with the left button across a field, one pixel at a time.
inline void scrub(QWidget* field, int pixels, Qt::KeyboardModifiers keys = {}) {
  const QPointF start = QRectF(field->rect()).center();
  const auto send = [&](QEvent::Type type, double x, Qt::MouseButtons buttons) {
    const QPointF at = start + QPointF(x, 0);
    QMouseEvent event(type, at, field->mapToGlobal(at),
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons, keys);
    QCoreApplication::sendEvent(field, &event);
  };
  send(QEvent::MouseButtonPress, 0, Qt::LeftButton);
  const int sign = pixels < 0 ? -1 : 1;
  for (int k = 1; k <= sign * pixels; ++k) send(QEvent::MouseMove, sign * k, Qt::LeftButton);
  send(QEvent::MouseButtonRelease, pixels, Qt::NoButton);
}

/// Returns how much of a field's width the line at its bottom takes, of a field without the focus.
inline double lineShare(QWidget* field) {
  const QImage picture = field->grab().toImage();
  int length = 0;
  for (int x = 0; x < picture.width(); ++x)
    length += int(picture.pixelColor(x, picture.height() - 3) == hogelscope::tokens().strongLine);
  return double(length) / picture.width();
}
