// SPDX-License-Identifier: BSD-3-Clause
// Tests what long work says of the time left.
#include <QTest>

#include "core/base/progress.h"

using namespace hogelscope;

class TestProgress : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void timeLeft_data();
  void timeLeft();
};

void TestProgress::timeLeft_data() {
  QTest::addColumn<double>("seconds");
  QTest::addColumn<double>("done");
  QTest::addColumn<QString>("text");
  QTest::newRow("too early") << 1.0 << 0.5 << "";
  QTest::newRow("too little") << 10.0 << 0.005 << "";
  QTest::newRow("nothing yet") << 10.0 << 0.0 << "";
  QTest::newRow("done") << 10.0 << 1.0 << "";
  QTest::newRow("as long again") << 65.0 << 0.5 << "1:05 left";
  QTest::newRow("a third") << 30.0 << 0.75 << "0:10 left";
  QTest::newRow("hours") << 370.0 << 0.05 << "1:57:10 left";
}

void TestProgress::timeLeft() {
  QFETCH(double, seconds);
  QFETCH(double, done);
  QTEST(QString::fromStdString(hogelscope::timeLeft(seconds, done)), "text");
}

QTEST_GUILESS_MAIN(TestProgress)
#include "test_progress.moc"
