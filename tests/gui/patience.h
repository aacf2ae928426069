// SPDX-License-Identifier: BSD-3-Clause
// How long tests of the window wait. None passes by being quick, and a machine may have much other
// work: what must come may take its time.
#pragma once

#include <QDeadlineTimer>
#include <QtTest>

inline constexpr int patience = 120000;  ///< milliseconds

/// Handles no event meanwhile, as a busy window; false where it waited in vain.
template <class Condition>
bool sleepUntil(Condition condition) {
  const QDeadlineTimer deadline(patience);
  while (!condition() && !deadline.hasExpired()) QTest::qSleep(1);
  return condition();
}
