// SPDX-License-Identifier: BSD-3-Clause
// Tests the round values of axes.
#include "core/base/axis.h"

#include <QStringList>
#include <QTest>
#include <cmath>

using namespace hogelscope;

namespace {

double valueOf(QString text) {
  return text.replace(QChar(0x2212), '-').toDouble();
}

}  // namespace

class TestAxis : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void linear_data();
  void linear();
  void logarithmic_data();
  void logarithmic();
  void roundValues();
};

void TestAxis::linear_data() {
  QTest::addColumn<double>("low");
  QTest::addColumn<double>("high");
  QTest::addColumn<QString>("texts");
  QTest::newRow("whole") << -0.4 << 10.2 << "0 2 4 6 8 10";
  QTest::newRow("small") << -0.25 << 0.25 << "−0.2 −0.1 0.0 0.1 0.2";
  QTest::newRow("large") << 0.0 << 4e6 << "0 1000000 2000000 3000000 4000000";
  QTest::newRow("ends count") << 20.0 << 21.0 << "20.0 20.2 20.4 20.6 20.8 21.0";
  QTest::newRow("fine") << 0.001 << 0.0019 << "0.0010 0.0012 0.0014 0.0016 0.0018";
}

void TestAxis::linear() {
  QFETCH(const double, low);
  QFETCH(const double, high);
  QFETCH(const QString, texts);
  QStringList found;
  for (const Tick& tick : linearTicks({low, high, 0, 1}, 6)) {
    found.push_back(QString::fromStdString(tick.text));
    QVERIFY(std::abs(tick.value - valueOf(found.last())) < 1e-9);
  }
  QCOMPARE(found.join(' '), texts);
}

void TestAxis::logarithmic_data() {
  QTest::addColumn<double>("low");
  QTest::addColumn<double>("high");
  QTest::addColumn<int>("count");
  QTest::addColumn<QString>("texts");
  QTest::newRow("one decade") << 0.0 << 1.0 << 10 << "1 2 5 10";
  QTest::newRow("small") << -3.0 << -2.0 << 10 << "0.001 0.002 0.005 0.01";
  QTest::newRow("powers alone") << -1.0 << 4.0 << 46 << "0.1 1 10 100 1000 10000";
  QTest::newRow("every other") << -0.5 << 8.5 << 81 << "1 100 10000 1e+06 1e+08";
  QTest::newRow("tiny") << -7.0 << -6.0 << 10 << "1e−07 2e−07 5e−07 1e−06";
}

/// On 100 points, texts at least 17 apart.
void TestAxis::logarithmic() {
  QFETCH(const double, low);
  QFETCH(const double, high);
  QFETCH(const int, count);
  QFETCH(const QString, texts);
  QStringList found;
  const std::vector<Tick> ticks = logarithmicTicks({low, high, 100, 0}, 17);
  for (const Tick& tick : ticks) {
    if (tick.text.empty()) continue;
    found.push_back(QString::fromStdString(tick.text));
    QVERIFY(std::abs(tick.value / valueOf(found.last()) - 1) < 1e-9);
  }
  QCOMPARE(found.join(' '), texts);
  QCOMPARE(int(ticks.size()), count);
}

void TestAxis::roundValues() {
  QCOMPARE(tickStep(10, 5), 2.0);
  QCOMPARE(tickStep(10.1, 5), 5.0);
  QCOMPARE(tickStep(0.03, 4), 0.01);
}

QTEST_APPLESS_MAIN(TestAxis)
#include "test_axis.moc"
