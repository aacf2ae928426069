// SPDX-License-Identifier: BSD-3-Clause
// How a worker's thread answers the object that started it.
#pragma once

#include <QMetaObject>
#include <utility>

namespace hogelscope {

/// Calls `answer` on the object's own thread, from any other one, unless a newer question has been
/// asked by then: what waits in the queue would be the answer to an older one. `latest` counts the
/// questions; it is a member of the object, which only its own thread changes.
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
