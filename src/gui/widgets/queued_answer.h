// SPDX-License-Identifier: BSD-3-Clause
// Answers of a worker's thread to the object that started it, through the window's queue. Each has
// the number of its question; an overtaken answer is dropped.
#pragma once

#include <QMetaObject>
#include <utility>

namespace hogelscope {

/// Calls `answer` on the object's own thread, from any other thread, unless a newer question has
/// been asked by then. `latest` counts the questions; it is a member of the object that only the
/// object's thread changes.
template <class Answer>
void queueAnswer(QObject* object, const int& latest, int number, Answer answer) {
  QMetaObject::invokeMethod(
      object,
      [&latest, number, answer = std::move(answer)] {
        if (number == latest) answer();
      },
      Qt::QueuedConnection);
}

}  // namespace hogelscope
