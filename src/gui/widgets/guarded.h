// SPDX-License-Identifier: BSD-3-Clause
// Errors of a user's action become the failed() signal of the object that does it.
#pragma once

#include <QString>
#include <exception>

namespace hogelscope {

/// Runs `action`. Returns false if it throws, after `object` has emitted failed() with the message.
template <class Object, class Action>
bool guarded(Object* object, Action action) {
  try {
    action();
    return true;
  } catch (const std::exception& error) {
    Q_EMIT object->failed(QString::fromUtf8(error.what()));
    return false;
  }
}

}  // namespace hogelscope
