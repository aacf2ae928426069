// SPDX-License-Identifier: BSD-3-Clause
// Tests what the progress bar says of the time left.
#include <QTest>

#include "cli/progress_bar.h"

using namespace hogelscope;

class TestProgressBar : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void timeLeft_data();
  void timeLeft();
};

void TestProgressBar::timeLeft_data() {
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

void TestProgressBar::timeLeft() {
  QFETCH(double, seconds);
  QFETCH(double, done);
  QTEST(QString::fromStdString(hogelscope::timeLeft(seconds, done)), "text");
}

QTEST_GUILESS_MAIN(TestProgressBar)
#include "test_progress_bar.moc"
