// SPDX-License-Identifier: BSD-3-Clause
// Tests that depths in charts, which are files, do not depend on the user's language.
#include <QLocale>
#include <QTest>

#include "chart/depth_bar.h"

using namespace hogelscope;

class TestDepthBar : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void inEveryLanguage_data();
  void inEveryLanguage();
};

void TestDepthBar::inEveryLanguage_data() {
  QTest::addColumn<QString>("name");
  for (const char* const name : {"C", "de_DE", "tr_TR", "fa_IR"}) QTest::newRow(name) << name;
}

void TestDepthBar::inEveryLanguage() {
  QFETCH(QString, name);
  QLocale::setDefault(QLocale(name));
  QCOMPARE(inCentimetres(0.05), QString("+5.0"));
  QCOMPARE(inCentimetres(-0.123), QString("−12"));
  QCOMPARE(inCentimetres(-INFINITY), QString("−∞"));
}

QTEST_GUILESS_MAIN(TestDepthBar)
#include "test_depth_bar.moc"
