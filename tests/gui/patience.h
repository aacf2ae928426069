// SPDX-License-Identifier: BSD-3-Clause
// Waiting in tests of the window. No test passes by being quick, and a machine may have much other
// work: what must come may take its time.
#pragma once

#include <QApplication>
#include <QDeadlineTimer>
#include <QtTest>

inline constexpr int patience = 120000;  ///< milliseconds

/// Makes `window` the active one. X has no window manager in the tests, so the window asks for the
/// keyboard itself.
inline void activate(QWidget* window) {
  window->activateWindow();
  QTRY_COMPARE_WITH_TIMEOUT(QApplication::activeWindow(), window, patience);
}

/// Handles no event meanwhile, as a busy window; false where it waited in vain.
template <class Condition>
bool sleepUntil(Condition condition) {
  const QDeadlineTimer deadline(patience);
  while (!condition() && !deadline.hasExpired()) QTest::qSleep(1);
  return condition();
}
