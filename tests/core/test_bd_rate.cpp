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
  for (RatePoint& point : points) point = {point.rate * rateFactor, point.psnr + decibels};
  return points;
}

/// A curve whose PSNR rises with the rate.
Points randomCurve(Random& random) {
  Points points{{random.uniform(0.01, 0.1), random.uniform(20, 30)}};
  const int count = random.integer(4, 9);
  while (int(points.size()) < count)
    points.push_back(
        {points.back().rate * random.uniform(1.2, 3), points.back().psnr + random.uniform(1, 5)});
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
  void integralsAsSciPy();
  void problems_data();
  void problems();
  void ratesThatDoNotOverlap();
};

void TestBdRate::itself() {
  const BdDelta delta = bdDelta(curve, curve);
  QCOMPARE(delta.rate, 0.0);
  QCOMPARE(delta.psnr, 0.0);
  QCOMPARE(delta.psnrFrom, 28.1);
  QCOMPARE(delta.psnrTo, 38.3);
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
  QVERIFY(std::abs(bdDelta(curve, changed(curve, 1, 0.75)).psnr - 0.75) < 1e-10);
  QVERIFY(std::abs(bdDelta(curve, changed(curve, 1, -2)).psnr + 2) < 1e-10);
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
  QVERIFY(std::abs(delta.psnr - 3) < 1e-10);
}

void TestBdRate::orderOfPointsDoesNotMatter() {
  Points mixed = other;
  std::swap(mixed[0], mixed[2]);
  QCOMPARE(bdDelta(curve, mixed).rate, bdDelta(curve, other).rate);
  QCOMPARE(bdDelta(mixed, curve).psnr, bdDelta(other, curve).psnr);
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
    QVERIFY(std::abs(there.psnr + back.psnr) < 1e-9);
  }
  QVERIFY(compared > 500);
}

/// scipy.interpolate.PchipInterpolator 1.10.1, its integrate() over the overlap.
void TestBdRate::asSciPy() {
  const BdDelta delta = bdDelta(curve, other);
  QVERIFY(std::abs(delta.rate + 15.86227634542543) < 1e-9);
  QVERIFY(std::abs(delta.psnr - 0.6026006460872128) < 1e-9);
  QCOMPARE(delta.psnrFrom, 28.1);
  QCOMPARE(delta.psnrTo, 37.1);
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
                         << "the PSNRs do not overlap: 28.1 to 38.3 dB, and 48 to 57.1 dB";
  QTest::newRow("touching") << Points{{1, 1}, {2, 2}, {3, 3}, {4, 4}}
                            << Points{{5, 4}, {6, 5}, {7, 6}, {8, 7}}
                            << "the PSNRs do not overlap: 1 to 4 dB, and 4 to 7 dB";
  QTest::newRow("falling") << curve << Points{{1, 30}, {2, 31}, {3, 30.5}, {4, 35}}
                           << "the test's PSNR does not rise from a rate of 2 to 3";
  QTest::newRow("one rate twice") << Points{{1, 30}, {2, 31}, {2, 32}, {4, 35}} << curve
                                  << "the anchor's PSNR does not rise from a rate of 2 to 2";
  QTest::newRow("no bits") << Points{{0, 30}, {2, 31}, {3, 32}, {4, 35}} << curve
                           << "the anchor has a rate of 0, not a positive number";
  QTest::newRow("lossless") << curve << Points{{1, 30}, {2, 31}, {3, 32}, {4, nan}}
                            << "the test has no finite PSNR at a rate of 4";
}

void TestBdRate::problems() {
  QFETCH(const Points, anchor);
  QFETCH(const Points, test);
  QFETCH(const QString, problem);
  const BdDelta delta = bdDelta(anchor, test);
  QCOMPARE(QString::fromStdString(delta.problem), problem);
  QVERIFY(std::isnan(delta.rate) && std::isnan(delta.psnr));
}

void TestBdRate::ratesThatDoNotOverlap() {
  const BdDelta delta = bdDelta(curve, changed(curve, 100, 0));
  QVERIFY(std::abs(delta.rate - 9900) < 1e-8);
  QVERIFY(std::isnan(delta.psnr));
  QCOMPARE(delta.problem, std::string("the rates do not overlap: no BD-PSNR"));
}

QTEST_APPLESS_MAIN(TestBdRate)
#include "test_bd_rate.moc"
