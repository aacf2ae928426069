// SPDX-License-Identifier: BSD-3-Clause
// Tests the bootstrap against normal theory, in corner cases and for its speed.
#include <QTest>
#include <cmath>

#include "core/metrics/statistics.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

/// Units of (value, 1).
std::vector<std::vector<double>> unitsOf(const std::vector<double>& values) {
  std::vector<std::vector<double>> units;
  for (const double value : values) units.push_back({value, 1});
  return units;
}

std::vector<double> mean(const std::vector<double>& sums) {
  return {sums[0] / sums[1]};
}

std::vector<double> sample(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(random.uniform(20, 40));
  return values;
}

}  // namespace

class TestStatistics : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void meansAndQuantilesOfHistograms();
  void testsOfSigns();
  void twoLevels();
  void ofConstants();
  void ofOneUnit();
  void ofNothing();
  void isSeeded();
  void isTheSameEverywhere();
  void likeNormalTheory();
  void holdsTheMean();
  void rareFigures();
  void twoValues();
};

void TestStatistics::ofConstants() {
  const auto intervals = bootstrap(unitsOf({7, 7, 7, 7}), mean);
  QCOMPARE(intervals.size(), std::size_t(1));
  QCOMPARE(intervals[0].low, 7.0);
  QCOMPARE(intervals[0].high, 7.0);
}

void TestStatistics::ofOneUnit() {
  const auto intervals = bootstrap(unitsOf({3.5}), mean);
  QCOMPARE(intervals[0].low, 3.5);
  QCOMPARE(intervals[0].high, 3.5);
}

void TestStatistics::ofNothing() {
  const auto nothing = [](const std::vector<double>&) { return std::vector<double>{std::nan("")}; };
  const auto intervals = bootstrap({}, nothing);
  QVERIFY(std::isnan(intervals[0].low) && std::isnan(intervals[0].high));
}

void TestStatistics::isSeeded() {
  const auto units = unitsOf(sample(50, 1));
  QCOMPARE(resamplesFor(0), 10000);
  QCOMPARE(resamplesFor(2000), 10000);
  QCOMPARE(resamplesFor(4000), 5000);
  QCOMPARE(resamplesFor(100000), 1000);
  const Interval one = bootstrap(units, mean)[0];
  const Interval again = bootstrap(units, mean)[0];
  const Interval another = bootstrap(units, mean, {10000, 0.95, 2})[0];
  QVERIFY(one.low == again.low && one.high == again.high);
  QVERIFY(one.low != another.low);
  QVERIFY(std::abs(one.low - another.low) < 0.2);
}

/// Figures of an independent program: draws must not depend on the standard library.
void TestStatistics::isTheSameEverywhere() {
  const Interval interval = bootstrap(unitsOf({1, 2, 4, 8, 16, 32, 64}), mean, {1000, 0.9, 42})[0];
  QCOMPARE(interval.low * 7, 47.0);
  QCOMPARE(interval.high * 7, 224.0);
}

/// The mean's standard error times 1.96 to both sides, for many units.
void TestStatistics::likeNormalTheory() {
  const std::vector<double> values = sample(1000, 5);
  double sum = 0, squares = 0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const double average = sum / 1000;
  const double error = std::sqrt((squares / 1000 - average * average) / 1000);
  const Interval interval = bootstrap(unitsOf(values), mean)[0];
  QVERIFY(std::abs(interval.low - (average - 1.959964 * error)) < 0.05 * error);
  QVERIFY(std::abs(interval.high - (average + 1.959964 * error)) < 0.05 * error);
}

/// 95 % intervals of 40 units miss the true mean, 30, in about 5 % of samples.
void TestStatistics::holdsTheMean() {
  int missed = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Interval interval = bootstrap(unitsOf(sample(40, seed)), mean, {400, 0.95, seed})[0];
    missed += interval.low > 30 || interval.high < 30 ? 1 : 0;
  }
  QVERIFY2(missed > 30 && missed < 90, qPrintable(QString::number(missed)));
}

/// Draws that give no number leave the others alone.
void TestStatistics::rareFigures() {
  const std::vector<std::vector<double>> units{{5, 1}, {0, 0}};
  const Interval interval = bootstrap(units, mean)[0];  // a quarter of the draws is 0/0
  QCOMPARE(interval.low, 5.0);
  QCOMPARE(interval.high, 5.0);
}

/// The mean of two draws of 0 and 1 is 0 or 1 in a quarter of the resamples each.
void TestStatistics::twoValues() {
  const auto units = unitsOf({0, 1});
  QCOMPARE(bootstrap(units, mean)[0].low, 0.0);
  QCOMPARE(bootstrap(units, mean)[0].high, 1.0);
  QCOMPARE(bootstrap(units, mean, {10000, 0.4, 1})[0].low, 0.5);
  QCOMPARE(bootstrap(units, mean, {10000, 0.4, 1})[0].high, 0.5);
}

/// SciPy 1.11's binomtest and wilcoxon(method="exact") for Darwin's maize, and all assignments of
/// signs to numbers some of which are equal.
void TestStatistics::testsOfSigns() {
  const std::vector<double> maize{6, 8, 14, 16, 23, 24, 28, 29, 41, -48, 49, 56, 60, -67, 75};
  QVERIFY(std::abs(signTest(maize) - 0.00738525390625) < 1e-15);
  QVERIFY(std::abs(signedRankTest(maize) - 0.041259765625) < 1e-15);
  QVERIFY(std::isnan(signTest({0, std::nan("")})) && std::isnan(signedRankTest({})));
  QCOMPARE(signTest({3, 0, -4}), 1.0);

  Random random(4);
  for (int k = 0; k < 30; ++k) {
    std::vector<double> values;
    const int count = random.integer(1, 9);
    for (int n = 0; n < count; ++n)
      values.push_back((random.integer(0, 1) == 0 ? -1 : 1) * random.integer(1, 6));
    std::vector<double> sizes;
    for (const double value : values) sizes.push_back(std::abs(value));
    const std::vector<double> ranks = ranksOf(sizes);
    double whole = 0;
    for (const double rank : ranks) whole += rank;
    double above = 0, signs = 0;
    for (std::size_t n = 0; n < ranks.size(); ++n) {
      above += values[n] > 0 ? ranks[n] : 0;
      signs += values[n] > 0 ? 1 : 0;
    }
    int extremes = 0, asUnequal = 0;
    for (int chosen = 0; chosen < 1 << count; ++chosen) {
      double sum = 0, number = 0;
      for (int n = 0; n < count; ++n)
        if ((chosen >> n & 1) != 0) {
          sum += ranks[std::size_t(n)];
          ++number;
        }
      extremes += std::abs(sum - whole / 2) >= std::abs(above - whole / 2) ? 1 : 0;
      asUnequal += std::abs(number - count / 2.0) >= std::abs(signs - count / 2.0) ? 1 : 0;
    }
    QVERIFY(std::abs(signedRankTest(values) - double(extremes) / (1 << count)) < 1e-12);
    QVERIFY(std::abs(signTest(values) - double(asUnequal) / (1 << count)) < 1e-12);
  }
}

/// Two groups of one unit each: their mean is that of 0 and 1 in half of the draws. Groups of many
/// units: the variance of the mean is that of the groups' means and of the units in them.
void TestStatistics::twoLevels() {
  const auto meanOfGroups = [](const std::vector<DrawnGroup>& drawn) {
    double sum = 0;
    for (const DrawnGroup& group : drawn) sum += group.sums[0] / group.sums[1];
    return std::vector<double>{sum / double(drawn.size())};
  };
  const auto groupOf = [](std::vector<double> values) {
    std::vector<std::vector<double>> units;
    for (const double value : values) units.push_back({value, 1});
    return units;
  };
  const Interval two =
      nestedBootstrap({groupOf({0}), groupOf({1})}, meanOfGroups, {1000, 0.4, 1})[0];
  QCOMPARE(two.low, 0.5);
  QCOMPARE(two.high, 0.5);

  std::vector<std::vector<std::vector<double>>> groups;
  double ofMeans = 0, within = 0;
  std::vector<double> means;
  for (int group = 0; group < 40; ++group) {
    std::vector<double> values = sample(20, std::uint64_t(group));
    for (double& value : values) value += 3 * (group % 7);
    double sum = 0, squares = 0;
    for (const double value : values) sum += value;
    for (const double value : values) squares += std::pow(value - sum / 20, 2);
    means.push_back(sum / 20);
    within += squares / 20 / 20;  // the variance of a drawn group's mean
    groups.push_back(groupOf(values));
  }
  double middle = 0;
  for (const double value : means) middle += value / 40;
  for (const double value : means) ofMeans += std::pow(value - middle, 2);
  const double deviation = std::sqrt((ofMeans + within) / 40 / 40);
  const Interval interval = nestedBootstrap(groups, meanOfGroups, {.resamples = 4000})[0];
  QVERIFY(std::abs((interval.high - interval.low) / (2 * 1.96 * deviation) - 1) < 0.05);
  QVERIFY(std::abs((interval.high + interval.low) / 2 - middle) < 0.1 * deviation);
}

/// Against a sorted list.
void TestStatistics::meansAndQuantilesOfHistograms() {
  Random random(9);
  for (int k = 0; k < 50; ++k) {
    Histogram counts{};
    std::vector<int> values;
    const int count = random.integer(1, 300);
    for (int n = 0; n < count; ++n) {
      values.push_back(random.integer(k, 255));
      ++counts[std::size_t(values.back())];
    }
    std::sort(values.begin(), values.end());
    double sum = 0;
    for (const int value : values) sum += value;
    QVERIFY(std::abs(meanOf(counts) - sum / count) < 1e-9);
    for (const double share : {0.01, 0.25, 0.5, 0.99, 1.0}) {
      const auto rank = std::size_t(std::max(1.0, std::ceil(share * count - 1e-9)));
      QCOMPARE(quantileOf(counts, share), values[rank - 1]);
    }
  }
  QVERIFY(std::isnan(meanOf(Histogram{})));
}

QTEST_APPLESS_MAIN(TestStatistics)
#include "test_statistics.moc"
