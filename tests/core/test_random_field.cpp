// SPDX-License-Identifier: BSD-3-Clause
// Draws for the hogels of a twin: normal, correlated as they should be, and the same in parts.
#include "core/panel/random_field.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <vector>

using namespace hogelscope;

namespace {

QByteArray text(double measured, double law) {
  return QString("%1, law %2").arg(measured, 0, 'g', 8).arg(law, 0, 'g', 8).toUtf8();
}

double valueAt(const std::vector<float>& values, int width, int i, int j) {
  return double(values[std::size_t(j) * std::size_t(width) + std::size_t(i)]);
}

/// The part of a field that is drawn, with columns left of the display's.
constexpr GridPart drawnPart{-30, 20, 160, 120};

/// Returns the mean of the products of values that are `right` and `down` cells apart.
double correlation(const std::vector<float>& a, const std::vector<float>& b, int right = 0,
                   int down = 0) {
  const auto& [left, top, width, height] = drawnPart;
  double sum = 0;
  for (int j = 0; j + down < height; ++j)
    for (int i = 0; i + right < width; ++i)
      sum += valueAt(a, width, i, j) * valueAt(b, width, i + right, j + down);
  return sum / ((width - right) * (height - down));
}

}  // namespace

class TestRandomField : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void drawsAreNormal();
  void fieldsAreCorrelated();
  void partsOfFieldsAreThoseFields();
};

/// The moments of a normal number are 0, 1, 0, 3, and |x| < s has the probability erf(s/√2).
void TestRandomField::drawsAreNormal() {
  constexpr int side = 500;
  std::array<double, 5> moments{};
  std::array<double, 4> within{};
  for (int j = -side / 2; j < side / 2; ++j)
    for (int i = -side / 2; i < side / 2; ++i) {
      const double x = normalAt(7, 1, i, j);
      for (std::size_t n = 1; n < moments.size(); ++n) moments[n] += std::pow(x, n) / (side * side);
      for (std::size_t n = 0; n < within.size(); ++n)
        if (std::abs(x) < 0.5 + double(n)) within[n] += 1.0 / (side * side);
    }
  // Five standard deviations of a mean of 250 000: √(var(xⁿ)/250 000), var = 1, 2, 15, 96.
  const std::array<double, 5> law{0, 0, 1, 0, 3};
  const std::array<double, 5> variance{0, 1, 2, 15, 96};
  for (std::size_t n = 1; n < moments.size(); ++n)
    QVERIFY2(std::abs(moments[n] - law[n]) < 5 * std::sqrt(variance[n]) / side,
             text(moments[n], law[n]));
  for (std::size_t n = 0; n < within.size(); ++n) {
    const double share = std::erf((0.5 + double(n)) / std::sqrt(2));
    QVERIFY2(std::abs(within[n] - share) < 5 * 0.5 / side, text(within[n], share));
  }
}

/// Values d cells apart are correlated by exp(−d²/length²), draws that are told apart not at all.
void TestRandomField::fieldsAreCorrelated() {
  const double length = 6;
  constexpr std::uint32_t seeds = 16;
  std::vector<std::vector<float>> fields;
  for (std::uint32_t seed = 1; seed <= seeds + 1; ++seed)
    fields.push_back(randomField(seed, 1, length, drawnPart));
  const auto meanOf = [](const auto& valueOfSeed) {
    double mean = 0;
    for (std::uint32_t k = 0; k < seeds; ++k) mean += valueOfSeed(k) / seeds;
    return mean;
  };
  using Step = std::array<int, 2>;
  for (const auto [right, down] : {Step{0, 0}, {3, 0}, {6, 0}, {9, 0}, {0, 3}, {0, 6}, {4, 4}}) {
    const double measured = meanOf([&, right = right, down = down](std::uint32_t k) {
      return correlation(fields[k], fields[k], right, down);
    });
    const double law = std::exp(-(right * right + down * down) / (length * length));
    QVERIFY2(std::abs(measured - law) < 0.05, text(measured, law));
  }
  const std::vector<float> ones(fields[0].size(), 1);
  const double mean = meanOf([&](std::uint32_t k) { return correlation(fields[k], ones); });
  QVERIFY2(std::abs(mean) < 0.05, text(mean, 0));
  const double ofSeeds =
      meanOf([&](std::uint32_t k) { return correlation(fields[k], fields[k + 1]); });
  QVERIFY2(std::abs(ofSeeds) < 0.05, text(ofSeeds, 0));
  const double ofDraws = meanOf([&](std::uint32_t k) {
    return correlation(fields[k], randomField(k + 1, 2, length, drawnPart));
  });
  QVERIFY2(std::abs(ofDraws) < 0.05, text(ofDraws, 0));
  const std::vector<float> independent = randomField(1, 1, 0, drawnPart);
  for (const auto [right, down] : {Step{1, 0}, {0, 1}, {1, 1}}) {
    const double ofCells = correlation(independent, independent, right, down);
    QVERIFY2(std::abs(ofCells) < 0.03, text(ofCells, 0));
  }
}

void TestRandomField::partsOfFieldsAreThoseFields() {
  const GridPart part{13, -2, 9, 7};
  for (const double length : {0.0, 1.0, 6.0}) {
    const std::vector<float> all = randomField(3, 0, length, {-5, -8, 40, 30});
    const std::vector<float> alone = randomField(3, 0, length, part);
    for (int j = 0; j < part.height; ++j)
      for (int i = 0; i < part.width; ++i)
        QVERIFY(valueAt(alone, part.width, i, j) ==
                valueAt(all, 40, part.i + i + 5, part.j + j + 8));
  }
}

QTEST_GUILESS_MAIN(TestRandomField)
#include "test_random_field.moc"
