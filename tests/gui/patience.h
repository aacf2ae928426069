// SPDX-License-Identifier: BSD-3-Clause
// Waiting in tests of the window. No test depends on speed, because a machine may be busy.
#pragma once

#include <QApplication>
#include <QDeadlineTimer>
#include <QtTest>

inline constexpr int patience = 120000;  ///< milliseconds

/// Activates `window`. The tests' X server has no window manager, so the window requests the
/// keyboard focus itself.
inline void activate(QWidget* window) {
  window->activateWindow();
  QTRY_COMPARE_WITH_TIMEOUT(QApplication::activeWindow(), window, patience);
}

/// Sleeps without handling events, like a busy window. Returns false after a timeout.
template <class Condition>
bool sleepUntil(Condition condition) {
  const QDeadlineTimer deadline(patience);
  while (!condition() && !deadline.hasExpired()) QTest::qSleep(1);
  return condition();
}
