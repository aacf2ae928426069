// SPDX-License-Identifier: BSD-3-Clause
// Leakage of twins against closed forms: it grows to the sides of the field, colours are diffracted
// at a square lens, and kernels are those of their part of the field.
#include "core/optics/field_leakage.h"

#include <QTest>
#include <cmath>
#include <numbers>

#include "tests/core/random_twin.h"

using namespace hogelscope;

namespace {

constexpr double pi = std::numbers::pi;

/// Hogels of 0.2 mm with fields of 40 degrees.
PanelParams displayOf(int directions) {
  PanelParams display;
  display.size = {4e-4, 4e-4};
  display.hogels = {2, 2};
  display.directions = {directions, directions};
  display.fov = {40, 40};
  return display;
}

/// Returns Σ w cos(phase k) / Σ w along u, of all taps along v.
double modulation(const std::vector<double>& weights, int reach, double phase) {
  const int side = 2 * reach + 1;
  double sum = 0;
  double total = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double w = weights[std::size_t(y * side + x)];
      sum += w * std::cos(phase * (x - reach));
      total += w;
    }
  return sum / total;
}

}  // namespace

class TestFieldLeakage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void growsToTheSides();
  void colourIsDiffracted_data();
  void colourIsDiffracted();
  void kernelsOfTheirPart();
  void kernelsLargerThanTheHogel_data();
  void kernelsLargerThanTheHogel();
  void isNotNeededWithoutErrors();
};

/// Of alternating directions |Σ w cos(πk)|/Σ w is left. With all taps it is the Gaussian's
/// transform, by Poisson's sum 2 exp(-π²σ²/2)/(1 + 2 exp(-2π²σ²)) but for 1e-6.
void TestFieldLeakage::growsToTheSides() {
  TwinParams params;
  params.leakage.sigmaGrowth = 1.5;
  const PanelParams display = displayOf(48);
  const Twin twin(params, {}, display);
  const PsfParams psf{0.5, 21};
  const FieldLeakage leakage(twin, psf);
  QCOMPARE(leakage.reach(), 10);
  for (const auto& [u, v] : {std::pair{24, 23}, {36, 24}, {47, 24}, {0, 0}}) {
    const double x = (u + 0.5) / 24 - 1;
    const double y = (v + 0.5) / 24 - 1;
    const double sigma = 0.5 * (1 + 1.5 * (x * x + y * y));
    const double law = 2 * std::exp(-pi * pi * sigma * sigma / 2) /
                       (1 + 2 * std::exp(-2 * pi * pi * sigma * sigma));
    const double found = modulation(leakage.weights(u, v, 0), 10, pi);
    QVERIFY2(std::abs(found - law) < 1e-4,
             qPrintable(QString("%1 %2: %3, %4").arg(u).arg(v).arg(found).arg(law)));
  }
}

void TestFieldLeakage::colourIsDiffracted_data() {
  QTest::addColumn<double>("wavelength");
  QTest::addColumn<double>("frequency");
  QTest::addColumn<double>("z");
  QTest::newRow("green near") << 550e-9 << 300.0 << -0.01;
  QTest::newRow("green far") << 550e-9 << 300.0 << -0.03;
  QTest::newRow("blue fine") << 450e-9 << 600.0 << 0.02;
  QTest::newRow("red fine") << 650e-9 << 600.0 << 0.03;
}

/// A grating of the frequency f at the depth z keeps 1 - λ f |z|/p of its contrast, the transfer of
/// a square lens of the width p.
void TestFieldLeakage::colourIsDiffracted() {
  QFETCH(const double, wavelength);
  QFETCH(const double, frequency);
  QFETCH(const double, z);
  TwinParams params;
  params.colour.wavelengths = {wavelength, 0, 0};
  const PanelParams display = displayOf(400);
  const Twin twin(params, {}, display);
  const FieldLeakage leakage(twin, {});
  const double step = 2 * std::tan(pi / 9) / 400;  // of the slopes of two directions
  const double found =
      modulation(leakage.weights(200, 200, 0), leakage.reach(), 2 * pi * frequency * z * step);
  const double law = 1 - wavelength * frequency * std::abs(z) / 2e-4;
  QVERIFY2(std::abs(found - law) < 0.004, qPrintable(QString("%1, %2").arg(found).arg(law)));
  QVERIFY(std::abs(modulation(leakage.weights(200, 200, 1), leakage.reach(), 1) - 1) < 1e-12);
}

/// Four kernels, each of one weight, in another place and colour.
void TestFieldLeakage::kernelsOfTheirPart() {
  TwinParams params;
  params.maps.kernelTiles = 2;
  TwinMaps maps;
  for (std::size_t c = 0; c < 3; ++c) {
    maps.kernels[c] = {6, 6, std::vector<float>(36)};
    for (const int tile : {0, 1, 2, 3}) {
      const int x = 3 * (tile % 2) + (tile + int(c)) % 3;
      const int y = 3 * (tile / 2) + 1;
      maps.kernels[c].values[std::size_t(6 * y + x)] = 1;
    }
  }
  const Twin twin(params, maps, displayOf(10));
  const FieldLeakage leakage(twin, {});
  QCOMPARE(leakage.reach(), 1);
  const LightFieldSize size{2, 2, 10, 10};
  const auto column = [](const TexelIndex& at) {
    return Rgb{double(at.u), double(at.u), double(at.u)};
  };
  for (const auto& [u, v, tile] : {std::tuple{2, 2, 0}, {7, 2, 1}, {2, 7, 2}, {7, 7, 3}}) {
    const Rgb light = leakage.leaked(size, {0, 0, u, v}, column);
    QCOMPARE(light.r, double(u + tile % 3 - 1));
    QCOMPARE(light.g, double(u + (tile + 1) % 3 - 1));
    QCOMPARE(light.b, double(u + (tile + 2) % 3 - 1));
  }
}

void TestFieldLeakage::kernelsLargerThanTheHogel_data() {
  QTest::addColumn<PsfBorder>("border");
  QTest::newRow("renormalise") << PsfBorder::renormalise;
  QTest::newRow("clamp") << PsfBorder::clamp;
  QTest::newRow("black") << PsfBorder::black;
}

/// To the last bit the sum over all taps, of which those beside the hogel have no light, the
/// edge's, or count in the mean alone.
void TestFieldLeakage::kernelsLargerThanTheHogel() {
  QFETCH(const PsfBorder, border);
  constexpr int side = 21;
  constexpr int directions = 6;
  Random random(4);
  TwinMaps maps;
  for (auto& kernel : maps.kernels) kernel = randomPlane(random, side, side, 0, 1);
  const Twin twin({}, maps, displayOf(directions));
  const FieldLeakage leakage(twin, {1, 1, border});
  const LightFieldSize size{2, 2, directions, directions};
  const auto content = [](const TexelIndex& at) { return std::cos(7.0 * at.u + 13.0 * at.v); };
  const auto edge = [](int at) { return std::clamp(at, 0, directions - 1); };
  for (int v = 0; v < directions; ++v)
    for (int u = 0; u < directions; ++u) {
      double sum = 0;
      double total = 0;
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          const TexelIndex tap{0, 0, u + x - side / 2, v + y - side / 2};
          const TexelIndex inside{0, 0, edge(tap.u), edge(tap.v)};
          const double weight = double(maps.kernels[1].values[std::size_t(side * y + x)]);
          const bool isInside = tap.u == inside.u && tap.v == inside.v;
          if (isInside || border == PsfBorder::clamp) sum += weight * content(inside);
          if (isInside || border != PsfBorder::renormalise) total += weight;
        }
      const Rgb light = leakage.leaked(size, {0, 0, u, v}, [&](const TexelIndex& at) {
        return Rgb{0, content(at), 0};
      });
      QVERIFY(light.g == sum / total);
    }
}

void TestFieldLeakage::isNotNeededWithoutErrors() {
  const PanelParams display = displayOf(10);
  const Twin plain({}, {}, display);
  QVERIFY(!FieldLeakage::isNeeded(nullptr, {0.5, 5}));
  QVERIFY(!FieldLeakage::isNeeded(&plain, {0.5, 5}));
  TwinParams params;
  params.leakage.sigmaGrowth = 1;
  const Twin grows(params, {}, display);
  QVERIFY(FieldLeakage::isNeeded(&grows, {0.5, 5}));
  QVERIFY(!FieldLeakage::isNeeded(&grows, {0.5, 1}));  // nothing leaks
}

QTEST_GUILESS_MAIN(TestFieldLeakage)
#include "test_field_leakage.moc"
