// SPDX-License-Identifier: BSD-3-Clause
// Tests the errors of a light field's own views against a loop, and rank correlations against
// scipy's.
#include "core/metrics/view_error.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/metrics/statistics.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

constexpr LightFieldSize size{19, 11, 5, 3};
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

LightField noise(StoredType type, std::uint64_t seed) {
  Random random(seed);
  const std::size_t count = 3 * size.width() * size.height();
  const auto filled = [&](auto values, auto next) {
    for (auto& value : values) value = next();
    return LightField(size, LightField::Values(values));
  };
  switch (type) {
    case StoredType::uint8:
      return filled(std::vector<std::uint8_t>(count),
                    [&] { return std::uint8_t(random.integer(0, 255)); });
    case StoredType::uint16:
      return filled(std::vector<std::uint16_t>(count),
                    [&] { return std::uint16_t(random.integer(0, 65535)); });
    default:
      return filled(std::vector<float>(count), [&] { return float(random.uniform(0, 2)); });
  }
}

/// The mean over all hogels of one view, read texel by texel.
double errorOf(const LightField& a, const LightField& b, int u, int v) {
  double sum = 0;
  for (int j = 0; j < size.ny; ++j)
    for (int i = 0; i < size.nx; ++i) {
      const Rgb x = a.texel({i, j, u, v});
      const Rgb y = b.texel({i, j, u, v});
      sum += std::pow(x.r - y.r, 2) + std::pow(x.g - y.g, 2) + std::pow(x.b - y.b, 2);
    }
  return sum / (3 * size.nx * size.ny);
}

PanelError perceived(const std::vector<PanelError::Cell>& directions, int du) {
  const LightFieldSize one{1, 1, du, int(directions.size()) / du};
  return {one, std::vector<PanelError::Cell>(1), directions};
}

}  // namespace

class TestViewError : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void ranks();
  void correlations();
  void nothingToCorrelate();
  void errors_data();
  void errors();
  void stops();
  void otherSizes();
  void agreement();
  void nothingSeen();
};

void TestViewError::ranks() {
  QVERIFY((ranksOf({30, 10, 20, 10}) == std::vector<double>{4, 1.5, 3, 1.5}));
  QVERIFY(ranksOf({}).empty());
}

/// scipy.stats.spearmanr of the same values.
void TestViewError::correlations() {
  const std::vector<double> a{3, 1, 4, 1, 5, 9, 2, 6, 5, 3};
  QVERIFY(std::abs(rankCorrelation(a, {2, 7, 1, 8, 2, 8, 1, 8, 2, 8}) - 0.13471506281091267) <
          1e-15);
  QCOMPARE(rankCorrelation({1, 2, 3}, {1, 10, 1e300}), 1.0);
  QCOMPARE(rankCorrelation({1, 2, 3}, {1, 0, -7}), -1.0);
  QCOMPARE(rankCorrelation({1, 2, notANumber, 3}, {1, 10, 0, 11}),
           1.0);  // the pair with NaN is left out
  const double infinity = std::numeric_limits<double>::infinity();
  QCOMPARE(rankCorrelation({1, 2, infinity}, {1, 2, 3}), 1.0);
}

void TestViewError::nothingToCorrelate() {
  QVERIFY(std::isnan(rankCorrelation({}, {})));
  QVERIFY(std::isnan(rankCorrelation({1}, {2})));
  QVERIFY(std::isnan(rankCorrelation({1, 1, 1}, {1, 2, 3})));
  QVERIFY_EXCEPTION_THROWN(rankCorrelation({1}, {1, 2}), std::invalid_argument);
}

void TestViewError::errors_data() {
  QTest::addColumn<int>("first");
  QTest::addColumn<int>("second");
  const char* const names[] = {"8 bit", "16 bit", "real"};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) QTest::addRow("%s, %s", names[a], names[b]) << a << b;
}

void TestViewError::errors() {
  QFETCH(const int, first);
  QFETCH(const int, second);
  const LightField a = noise(StoredType(first), 1);
  const LightField b = noise(StoredType(second), 2);
  const std::vector<double> errors = viewErrors(a, b, parallelRows);
  QCOMPARE(errors.size(), std::size_t(size.du * size.dv));
  for (int v = 0; v < size.dv; ++v)
    for (int u = 0; u < size.du; ++u) {
      const double expected = errorOf(a, b, u, v);
      QVERIFY(std::abs(errors[std::size_t(v * size.du + u)] - expected) <= 1e-12 * expected);
    }
  QVERIFY(errors == viewErrors(a, b, serialRows));
}

void TestViewError::stops() {
  const LightField a = noise(StoredType::uint8, 1);
  QVERIFY_EXCEPTION_THROWN(viewErrors(a, a, serialRows, [](double) { return false; }), Cancelled);
}

void TestViewError::otherSizes() {
  const LightField a = noise(StoredType::uint8, 1);
  const LightField b({1, 1, 1, 1}, StoredType::uint8);
  QVERIFY_EXCEPTION_THROWN(viewErrors(a, b, serialRows), std::invalid_argument);
  QVERIFY_EXCEPTION_THROWN(agreementOf({1, 2, 3}, perceived({{}, {}}, 2)), std::invalid_argument);
}

/// Three directions of six are seen in the order of their views' own errors but for two.
void TestViewError::agreement() {
  const PanelError seen = perceived({{30, 1}, {}, {90, 2}, {60, 1}, {12, 1}, {}}, 3);
  const ViewAgreement agreement = agreementOf({10, 1000, 20, 15, 0, 5}, seen);
  QCOMPARE(agreement.seen, 4);
  // Own ranks 2, 4, 3, 1; perceived 10, 15, 20, 4 have ranks 2, 3, 4, 1.
  QCOMPARE(agreement.rankCorrelation, 0.8);
  QCOMPARE(agreement.rankDifferences[0], 0.0);
  QCOMPARE(agreement.rankDifferences[2], -0.25);
  QCOMPARE(agreement.rankDifferences[3], 0.25);
  QVERIFY(std::isnan(agreement.rankDifferences[1]) && std::isnan(agreement.rankDifferences[5]));
  QVERIFY((agreement.underrated == std::array<int, 2>{0, 1}));
  // The mean of the PSNRs that are finite.
  double sum = 0;
  for (const double error : {10, 1000, 20, 15, 5}) sum += 10 * std::log10(255.0 * 255.0 / error);
  QVERIFY(std::abs(agreement.meanPsnr - sum / 5) < 1e-12);
  const std::string text = agreementText(agreement);
  QVERIFY(text.find("Over the 4 directions seen") != std::string::npos);
  QVERIFY(text.find(" is 0.80; ") != std::string::npos);
  QVERIFY(text.find("in view (0, 1).") != std::string::npos);
}

void TestViewError::nothingSeen() {
  const ViewAgreement agreement = agreementOf({1, 2}, perceived({{}, {}}, 2));
  QCOMPARE(agreement.seen, 0);
  QVERIFY(std::isnan(agreement.rankCorrelation));
  QVERIFY(agreementText(agreement).find("Too few") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestViewError)
#include "test_view_error.moc"
