// SPDX-License-Identifier: BSD-3-Clause
// Tests the light leakage against a double loop written here, and sRGB's transfer function.
#include <QTest>
#include <cmath>

#include "core/light_field/light_field.h"
#include "core/optics/psf.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

constexpr LightFieldSize size{2, 3, 5, 4};

enum class Stored { bytes, words, floats };

template <class T>
std::vector<T> randomValues(Random& random, double scale) {
  std::vector<T> values(3 * size.width() * size.height());
  for (T& value : values) value = static_cast<T>(random.uniform(0, scale));
  return values;
}

LightField randomLightField(Random& random, int stored) {
  if (stored == int(Stored::bytes)) return {size, randomValues<std::uint8_t>(random, 256)};
  if (stored == int(Stored::words)) return {size, randomValues<std::uint16_t>(random, 65536)};
  return {size, randomValues<float>(random, 1.5)};
}

double linear(double codeValue) {
  const double c = codeValue / 255;
  return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
}

/// P'(u, v) of docs/formulas.md, Light leakage, from the hogel's taps outwards.
Rgb expected(const PsfParams& psf, const LightField& lightField, const TexelIndex& at) {
  const int n = (psf.windowSize - 1) / 2;
  std::array<double, 3> sum{};
  double weights = 0;
  for (int v = at.v - n; v <= at.v + n; ++v) {
    for (int u = at.u - n; u <= at.u + n; ++u) {
      const double squared = std::pow(u - at.u, 2) + std::pow(v - at.v, 2);
      const double w = n == 0 ? 1 : std::exp(-squared / (2 * psf.sigma * psf.sigma));
      const int tapU = std::min(std::max(u, 0), size.du - 1);
      const int tapV = std::min(std::max(v, 0), size.dv - 1);
      const bool outside = tapU != u || tapV != v;
      if (!outside || psf.border != PsfBorder::renormalise) weights += w;
      if (outside && psf.border != PsfBorder::clamp) continue;
      const Rgb tap = lightField.texel({at.i, at.j, tapU, tapV});
      const bool decode = psf.light == LightModel::linear;
      sum[0] += w * (decode ? linear(tap.r) : tap.r);
      sum[1] += w * (decode ? linear(tap.g) : tap.g);
      sum[2] += w * (decode ? linear(tap.b) : tap.b);
    }
  }
  return {sum[0] / weights, sum[1] / weights, sum[2] / weights};
}

double difference(const Rgb& a, const Rgb& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

TexelIndex texelIndex(int k) {
  return {k % 2, k / 2 % 3, k / 6 % 5, k / 30};
}
constexpr int texelCount = 2 * 3 * 5 * 4;

const std::array borders{PsfBorder::renormalise, PsfBorder::clamp, PsfBorder::black};
const std::array lights{LightModel::encoded, LightModel::linear};

}  // namespace

class TestPsf : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Each weight against exp(-(x² + y²) / (2σ²)), all of them adding up to 1.
  void theKernelIsTheGaussianWindow() {
    const PsfParams params{1.3, 5};
    const std::vector<double> weights = psfKernel(params);
    QCOMPARE(weights.size(), std::size_t(25));
    double sum = 0;
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x) sum += std::exp(-(x * x + y * y) / (2 * 1.3 * 1.3));
    for (int k = 0; k < 25; ++k) {
      const int x = k % 5 - 2;
      const int y = k / 5 - 2;
      QVERIFY(std::abs(weights[std::size_t(k)] -
                       std::exp(-(x * x + y * y) / (2 * 1.3 * 1.3)) / sum) < 1e-15);
    }
    QVERIFY(psfKernel({0, 1}) == std::vector{1.0});
  }

  void stepsStayInTheRanges() {
    QCOMPARE(steppedSigma(0.1, 4), 0.3);  // without the rounding of 0.1 + 4 * 0.05
    QCOMPARE(steppedSigma(0.1, -1), 0.05);
    QCOMPARE(steppedSigma(0.05, -1), 0.05);  // 0 is no Gaussian
    QCOMPARE(steppedSigma(19.98, 1), 20.0);
    QCOMPARE(steppedWindow(1, 2), 5);
    QCOMPARE(steppedWindow(3, -2), 1);
    QCOMPARE(steppedWindow(97, 2), 99);
  }

  /// erf(3.5 / (2√2))² = 0.846 of σ = 2 in 7×7; σ = 1 in 7×7 keeps erf(3.5/√2)² = 0.99907.
  void aWindowThatCutsMoreThanOnePerCentIsTold() {
    QVERIFY(cutsTooMuch({2, 7}));
    QVERIFY(!cutsTooMuch({1, 7}));
    QVERIFY(!cutsTooMuch({2, 1}));
  }

  void isTheFormula_data();
  void isTheFormula();
  void windowOfOneIsTheTexel();
  void constantLightStays();
  void blackBorderLosesLight();
  void tinySigmaIsFinite();
  void energy();
  void transferFunction_data();
  void transferFunction();
  void transferFunctionTakesBack();
};

void TestPsf::isTheFormula_data() {
  QTest::addColumn<int>("windowSize");
  QTest::addColumn<int>("stored");
  for (const int windowSize : {1, 3, 5, 9, 15})
    for (const Stored stored : {Stored::bytes, Stored::words, Stored::floats})
      QTest::addRow("window %d, content %d", windowSize, int(stored)) << windowSize << int(stored);
}

void TestPsf::isTheFormula() {
  QFETCH(const int, windowSize);
  QFETCH(const int, stored);
  Random random(1);
  for (const PsfBorder border : borders) {
    for (const LightModel light : lights) {
      const LightField lightField = randomLightField(random, stored);
      const PsfParams params{random.uniform(0.3, 4), windowSize, border, light};
      const double tolerance = light == LightModel::linear ? 1e-14 : 1e-12;
      for (int k = 0; k < texelCount; ++k)
        QVERIFY(difference(Psf(params).leaked(lightField, texelIndex(k)),
                           expected(params, lightField, texelIndex(k))) < tolerance);
    }
  }
}

void TestPsf::windowOfOneIsTheTexel() {
  Random random(2);
  const LightField lightField = randomLightField(random, int(Stored::words));
  for (const PsfBorder border : borders)
    for (int k = 0; k < texelCount; ++k)
      for (const double sigma : {0.0, 0.67})
        QVERIFY(Psf({sigma, 1, border}).leaked(lightField, texelIndex(k)) ==
                lightField.texel(texelIndex(k)));
}

void TestPsf::constantLightStays() {
  const LightField lightField(size,
                              std::vector<std::uint8_t>(3 * size.width() * size.height(), 97));
  for (const PsfBorder border : {PsfBorder::renormalise, PsfBorder::clamp})
    for (const LightModel light : lights)
      for (const int windowSize : {3, 7, 21})
        for (int k = 0; k < texelCount; ++k) {
          const Rgb sum = Psf({1.3, windowSize, border, light}).leaked(lightField, texelIndex(k));
          QVERIFY(difference(encoded(light, sum), {97, 97, 97}) < 1e-11);
        }
}

void TestPsf::blackBorderLosesLight() {
  const LightField lightField(size,
                              std::vector<std::uint8_t>(3 * size.width() * size.height(), 97));
  const Psf psf({1.3, 3, PsfBorder::black});
  QVERIFY(difference(psf.leaked(lightField, {0, 0, 2, 2}), {97, 97, 97}) < 1e-11);
  const double w = std::exp(-1 / (2 * 1.3 * 1.3));
  const double kept = (1 + w) / (1 + 2 * w);  // of an axis, at its border
  QVERIFY(std::abs(psf.leaked(lightField, {0, 0, 0, 2}).r - 97 * kept) < 1e-11);
  QVERIFY(std::abs(psf.leaked(lightField, {0, 0, 4, 3}).g - 97 * kept * kept) < 1e-11);
}

void TestPsf::tinySigmaIsFinite() {
  Random random(3);
  const LightField lightField = randomLightField(random, int(Stored::bytes));
  for (const PsfBorder border : borders)
    for (const double sigma : {1e-200, 5e-324})
      for (int k = 0; k < texelCount; ++k)
        QVERIFY(Psf({sigma, 5, border}).leaked(lightField, texelIndex(k)) ==
                lightField.texel(texelIndex(k)));
}

void TestPsf::energy() {
  QVERIFY(std::abs(energyInWindow({2, 7}) - 0.846) < 0.001);
  QCOMPARE(energyInWindow({0, 1}), 1.0);
  QCOMPARE(energyInWindow({20, 1}), 1.0);
  QCOMPARE(energyInWindow({1e-200, 3}), 1.0);
  for (const double sigma : {0.4, 0.67, 2.0, 9.0}) {
    // The midpoint rule, over the half width of 5 directional pixels.
    double axis = 0;
    constexpr int parts = 20000;
    for (int k = 0; k < parts; ++k) {
      const double x = (k + 0.5) / parts * 2.5 / sigma;
      axis += 2 * std::exp(-x * x / 2) / std::sqrt(2 * std::acos(-1.0)) * 2.5 / sigma / parts;
    }
    QVERIFY(std::abs(energyInWindow({sigma, 5}) - axis * axis) < 1e-8);
  }
}

void TestPsf::transferFunction_data() {
  QTest::addColumn<double>("codeValue");
  QTest::addColumn<double>("light");
  QTest::newRow("black") << 0.0 << 0.0;
  QTest::newRow("straight part") << 10.0 << 0.003035269835488375;
  QTest::newRow("curved part") << 128.0 << 0.21586050011389926;
  QTest::newRow("white") << 255.0 << 1.0;
}

void TestPsf::transferFunction() {
  QFETCH(const double, codeValue);
  QFETCH(const double, light);
  QVERIFY(std::abs(linearFromEncoded(codeValue) - light) < 1e-15);
  QVERIFY(std::abs(encodedFromLinear(light) - codeValue) < 1e-12);
}

void TestPsf::transferFunctionTakesBack() {
  for (int k = 0; k <= 2550; ++k)
    QVERIFY(std::abs(encodedFromLinear(linearFromEncoded(k / 10.0)) - k / 10.0) < 1e-4);
  const Rgb colour{3, 77, 200};
  QVERIFY(decoded(LightModel::encoded, colour) == colour);
  QVERIFY(encoded(LightModel::encoded, colour) == colour);
  const Rgb there = decoded(LightModel::linear, colour);
  QVERIFY(difference(there, {linear(3), linear(77), linear(200)}) < 1e-15);
  QVERIFY(difference(encoded(LightModel::linear, there), colour) < 1e-9);
}

QTEST_APPLESS_MAIN(TestPsf)
#include "test_psf.moc"
