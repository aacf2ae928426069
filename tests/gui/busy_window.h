// SPDX-License-Identifier: BSD-3-Clause
// A window whose thread is busy while others work: what do they leave in its queue?
#pragma once

#include <QDeadlineTimer>
#include <QtTest>

/// Handles no event meanwhile; false where it waited in vain.
template <class Condition>
bool sleepUntil(Condition condition) {
  const QDeadlineTimer deadline(60000);
  while (!condition() && !deadline.hasExpired()) QTest::qSleep(1);
  return condition();
}
