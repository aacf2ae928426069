// SPDX-License-Identifier: BSD-3-Clause
// Tests Bjøntegaard's deltas in closed form and against SciPy's PchipInterpolator.
#include <QTest>
#include <cmath>

#include "core/metrics/bd_rate.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

using Points = std::vector<RatePoint>;

const Points curve{{0.05, 28.1}, {0.1, 30.9}, {0.25, 34.2}, {0.5, 36.4}, {1.0, 38.3}};
const Points other{{0.04, 28.0}, {0.09, 31.2}, {0.2, 34.0}, {0.55, 37.1}};

Points changed(Points points, double rateFactor, double decibels) {
  for (RatePoint& point : points) point = {point.rate * rateFactor, point.quality + decibels};
  return points;
}

/// A curve whose PSNR rises with the rate.
Points randomCurve(Random& random) {
  Points points{{random.uniform(0.01, 0.1), random.uniform(20, 30)}};
  const int count = random.integer(4, 9);
  while (int(points.size()) < count)
    points.push_back({points.back().rate * random.uniform(1.2, 3),
                      points.back().quality + random.uniform(1, 5)});
  return points;
}

}  // namespace

class TestBdRate : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void itself();
  void rateScaled_data();
  void rateScaled();
  void betterByDecibels();
  void straightLines();
  void orderOfPointsDoesNotMatter();
  void swapped();
  void asSciPy();
  void asTheSpreadsheet();
  void overSsim();
  void integralsAsSciPy();
  void problems_data();
  void problems();
  void ratesThatDoNotOverlap();
};

void TestBdRate::itself() {
  const BdDelta delta = bdDelta(curve, curve);
  QCOMPARE(delta.rate, 0.0);
  QCOMPARE(delta.quality, 0.0);
  QCOMPARE(delta.from, 28.1);
  QCOMPARE(delta.to, 38.3);
  QVERIFY(delta.problem.empty());
}

void TestBdRate::rateScaled_data() {
  QTest::addColumn<double>("factor");
  QTest::addColumn<double>("percent");
  QTest::newRow("half") << 0.5 << -50.0;
  QTest::newRow("twice") << 2.0 << 100.0;
  QTest::newRow("a tenth more") << 1.1 << 10.0;
}

void TestBdRate::rateScaled() {
  QFETCH(const double, factor);
  QFETCH(const double, percent);
  QVERIFY(std::abs(bdDelta(curve, changed(curve, factor, 0)).rate - percent) < 1e-10);
}

void TestBdRate::betterByDecibels() {
  QVERIFY(std::abs(bdDelta(curve, changed(curve, 1, 0.75)).quality - 0.75) < 1e-10);
  QVERIFY(std::abs(bdDelta(curve, changed(curve, 1, -2)).quality + 2) < 1e-10);
}

/// PSNR = 30 + 10 log10(rate): a decade of rate is 10 dB.
void TestBdRate::straightLines() {
  Points anchor, test;
  for (const double rate : {0.1, 0.2, 0.7, 2.0, 5.0})
    anchor.push_back({rate, 30 + 10 * std::log10(rate)});
  for (const double rate : {0.15, 0.3, 1.0, 3.0})
    test.push_back({rate, 33 + 10 * std::log10(rate)});
  const BdDelta delta = bdDelta(anchor, test);
  QVERIFY(std::abs(delta.rate - 100 * (std::pow(10, -0.3) - 1)) < 1e-10);
  QVERIFY(std::abs(delta.quality - 3) < 1e-10);
}

void TestBdRate::orderOfPointsDoesNotMatter() {
  Points mixed = other;
  std::swap(mixed[0], mixed[2]);
  QCOMPARE(bdDelta(curve, mixed).rate, bdDelta(curve, other).rate);
  QCOMPARE(bdDelta(mixed, curve).quality, bdDelta(other, curve).quality);
}

/// BD-PSNR changes its sign, and the ratios of the rates are each other's inverse.
void TestBdRate::swapped() {
  Random random(3);
  int compared = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Points a = randomCurve(random);
    const Points b = randomCurve(random);
    const BdDelta there = bdDelta(a, b);
    const BdDelta back = bdDelta(b, a);
    QCOMPARE(there.problem.empty(), back.problem.empty());
    if (!there.problem.empty()) continue;
    ++compared;
    QVERIFY(std::abs((1 + there.rate / 100) * (1 + back.rate / 100) - 1) < 1e-9);
    QVERIFY(std::abs(there.quality + back.quality) < 1e-9);
  }
  QVERIFY(compared > 500);
}

/// scipy.interpolate.PchipInterpolator 1.10.1, its integrate() over the overlap.
void TestBdRate::asSciPy() {
  const BdDelta delta = bdDelta(curve, other);
  QVERIFY(std::abs(delta.rate + 15.86227634542543) < 1e-9);
  QVERIFY(std::abs(delta.quality - 0.6026006460872128) < 1e-9);
  QCOMPARE(delta.from, 28.1);
  QCOMPARE(delta.to, 37.1);
}

/// The data of JCTVC-E137, which brought the spreadsheet to piecewise cubics, and the BD-rates that
/// the tests of Netflix's VMAF have for them.
void TestBdRate::asTheSpreadsheet() {
  const Points anchor{
      {108048.8736, 43.6471}, {61279.976, 40.3953}, {33905.6656, 37.247}, {18883.6928, 34.2911}};
  const Points test{
      {108061.2784, 43.6768}, {61299.9936, 40.4232}, {33928.7472, 37.2761}, {18910.912, 34.3147}};
  QVERIFY(std::abs(bdDelta(anchor, test).rate + 0.465215420752807) < 1e-9);
  const Points anchor2{
      {40433.8848, 37.5761}, {7622.7456, 35.3756}, {2394.488, 33.8977}, {1017.6184, 32.0603}};
  const Points test2{
      {40370.12, 37.5982}, {7587.0024, 35.4025}, {2390.0944, 33.9194}, {1017.0984, 32.0822}};
  QVERIFY(std::abs(bdDelta(anchor2, test2).rate + 1.8779823450567612) < 1e-9);
}

/// A quality between 0 and 1 is one as any other: SSIM = 0.5 + 0.1 log10(rate).
void TestBdRate::overSsim() {
  Points anchor, test;
  for (const double rate : {0.1, 0.3, 1.0, 4.0}) {
    anchor.push_back({rate, 0.5 + 0.1 * std::log10(rate)});
    test.push_back({rate / 2, 0.5 + 0.1 * std::log10(rate)});
  }
  const BdDelta delta = bdDelta(anchor, test);
  QVERIFY(std::abs(delta.rate + 50) < 1e-9);
  QVERIFY(std::abs(delta.quality - 0.1 * std::log10(2)) < 1e-12);
}

void TestBdRate::integralsAsSciPy() {
  QVERIFY(std::abs(pchipIntegral({0, 1, 2}, {0, 1, 20}, 0, 2) - 8.666666666666668) < 1e-12);
  const std::vector<double> x{0, 1, 2.5, 3, 5, 5.5, 8};
  const std::vector<double> y{1, 3, 2, 2, 7, 7.5, 0};
  QVERIFY(std::abs(pchipIntegral(x, y, 0, 8) - 31.892982456140352) < 1e-12);
  QVERIFY(std::abs(pchipIntegral(x, y, 0.3, 6.1) - 23.205933345029237) < 1e-12);
  QVERIFY(std::abs(pchipIntegral({0, 1}, {1, 3}, 0.25, 1) - 1.6875) < 1e-12);
  QVERIFY(std::abs(pchipIntegral({0, 1, 2.5}, {1, 3, 2}, 0.25, 2.5) - 6.036328125) < 1e-12);
  QVERIFY(std::abs(pchipIntegral({0, 1, 2}, {0, 1, 0}, 0, 2) - 1.3333333333333335) < 1e-12);
  QVERIFY(std::abs(pchipIntegral({0, 1, 4}, {0, 1, 10}, 0, 4) - 14.589743589743588) < 1e-12);
  QVERIFY(std::abs(pchipIntegral({0, 1, 2}, {0, 1, -8}, 0, 2) + 1.583333333333333) < 1e-12);
}

void TestBdRate::problems_data() {
  QTest::addColumn<Points>("anchor");
  QTest::addColumn<Points>("test");
  QTest::addColumn<QString>("problem");
  const double nan = std::nan("");
  QTest::newRow("three points") << curve << Points(other.begin(), other.begin() + 3)
                                << "the test has 3 points, but four are needed";
  QTest::newRow("none") << Points() << other << "the anchor has 0 points, but four are needed";
  QTest::newRow("apart") << curve << changed(other, 1, 20)
                         << "the qualities do not overlap: 28.1 to 38.3, and 48 to 57.1";
  QTest::newRow("touching") << Points{{1, 1}, {2, 2}, {3, 3}, {4, 4}}
                            << Points{{5, 4}, {6, 5}, {7, 6}, {8, 7}}
                            << "the qualities do not overlap: 1 to 4, and 4 to 7";
  QTest::newRow("falling") << curve << Points{{1, 30}, {2, 31}, {3, 30.5}, {4, 35}}
                           << "the test's quality does not rise from a rate of 2 to 3";
  QTest::newRow("one rate twice") << Points{{1, 30}, {2, 31}, {2, 32}, {4, 35}} << curve
                                  << "the anchor's quality does not rise from a rate of 2 to 2";
  QTest::newRow("no bits") << Points{{0, 30}, {2, 31}, {3, 32}, {4, 35}} << curve
                           << "the anchor has a rate of 0, not a positive number";
  QTest::newRow("lossless") << curve << Points{{1, 30}, {2, 31}, {3, 32}, {4, nan}}
                            << "the test has no finite quality at a rate of 4";
}

void TestBdRate::problems() {
  QFETCH(const Points, anchor);
  QFETCH(const Points, test);
  QFETCH(const QString, problem);
  const BdDelta delta = bdDelta(anchor, test);
  QCOMPARE(QString::fromStdString(delta.problem), problem);
  QVERIFY(std::isnan(delta.rate) && std::isnan(delta.quality));
}

void TestBdRate::ratesThatDoNotOverlap() {
  const BdDelta delta = bdDelta(curve, changed(curve, 100, 0));
  QVERIFY(std::abs(delta.rate - 9900) < 1e-8);
  QVERIFY(std::isnan(delta.quality));
  QCOMPARE(delta.problem, std::string("the rates do not overlap: no difference of quality"));
}

QTEST_APPLESS_MAIN(TestBdRate)
#include "test_bd_rate.moc"
