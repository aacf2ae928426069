// SPDX-License-Identifier: BSD-3-Clause
// The fast engine gives the reference's pixels, over random scenes with all options.
#include "core/engine/fast_simulation.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "tests/core/random_scene.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

struct Counts {
  int compared = 0;
  int seen = 0;
  int unclear = 0;
};

/// Small displays as in the other tests, or ones whose rows are longer than a batch and whose
/// hogels are wider than a window.
RandomScene sceneOf(std::uint64_t seed) {
  Random random(seed);
  RandomScene scene = randomSampledScene(random);
  if (random.flip()) return scene;
  scene.job.display.directions = {random.integer(9, 40), random.integer(9, 40)};
  fillDisplay(random, scene);
  scene.job.state.camera.res = {random.integer(130, 200), random.integer(2, 3)};
  return scene;
}

bool isNearHalf(double codeValue) {
  return std::abs(codeValue - std::floor(codeValue) - 0.5) < 1e-3;
}

/// Equal, or one code value apart where the sum is within a thousandth of a rounding half.
bool agrees(std::uint8_t fast, std::uint8_t reference, double codeValue) {
  return fast == reference || (std::abs(fast - reference) == 1 && isNearHalf(codeValue));
}

QString firstDifference(const RandomScene& scene, Counts& counts) {
  const Image fast = rendered(scene.job);
  const Simulation reference(scene.job);
  const brute::Simulator rays(scene.job, scene.content);
  for (std::size_t at = 0; at < fast.pixelCount(); ++at) {
    const int x = int(at) % fast.width;
    const int y = int(at) / fast.width;
    const std::optional<Rgb> light = reference.pixel(x, y);
    const Rgb value = light.value_or(PixelLight{});
    ++counts.compared;
    counts.seen += light ? 1 : 0;
    const bool equal = fast.seen[at] == (light ? 255 : 0) &&
                       agrees(fast.rgb[3 * at], quantised(value.r), value.r) &&
                       agrees(fast.rgb[3 * at + 1], quantised(value.g), value.g) &&
                       agrees(fast.rgb[3 * at + 2], quantised(value.b), value.b);
    if (equal) continue;
    if (!rays.isUnclear(x, y))
      return QString("pixel (%1, %2): red %3, reference %4, seen %5")
          .arg(x)
          .arg(y)
          .arg(fast.rgb[3 * at])
          .arg(value.r)
          .arg(fast.seen[at]);
    ++counts.unclear;
  }
  return {};
}

}  // namespace

class TestFastSimulation : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isTheReference();
  void plainScenesAreTheReference();
  void codeValuesAreTheReferences();
  void roundsAsTheReference();
};

void TestFastSimulation::isTheReference() {
  Counts counts;
  for (std::uint64_t seed = 5000; seed < 5500; ++seed) {
    const QString difference = firstDifference(sceneOf(seed), counts);
    QVERIFY2(difference.isEmpty(), qPrintable(QString("scene %1: ").arg(seed) + difference));
  }
  const QString found = QString("%1 compared, %2 seen, %3 unclear")
                            .arg(counts.compared)
                            .arg(counts.seen)
                            .arg(counts.unclear);
  QVERIFY2(counts.compared > 200000 && counts.seen > 30000 && counts.unclear < 50,
           qPrintable(found));
}

/// No lens, no leakage, 8 bits: the path that only copies, with each row's part known beforehand.
void TestFastSimulation::plainScenesAreTheReference() {
  Counts counts;
  for (std::uint64_t seed = 7000; seed < 7300; ++seed) {
    RandomScene scene = sceneOf(seed);
    Random random(seed);
    scene.content.codes.clear();
    fillWithNoise<std::uint8_t>(random, scene, 0, 256, 1);
    scene.job.sampling = {};
    if (random.flip()) scene.job.state.distortion = {};
    scene.job.state.psf = {};
    scene.job.display.lens = HogelLensModel::rectilinear;
    const QString difference = firstDifference(scene, counts);
    QVERIFY2(difference.isEmpty(), qPrintable(QString("scene %1: ").arg(seed) + difference));
  }
  QVERIFY2(counts.seen > 10000, qPrintable(QString::number(counts.seen)));
}

void TestFastSimulation::codeValuesAreTheReferences() {
  for (std::uint64_t seed = 8000; seed < 8050; ++seed) {
    const RandomScene scene = sceneOf(seed);
    const Simulation reference(scene.job);
    const brute::Simulator rays(scene.job, scene.content);
    LensTables tables;
    const FastSimulation fast(scene.job, tables, serialRows);
    const auto [width, height] = scene.job.state.camera.res;
    std::vector<float> rgb(3 * std::size_t(width));
    std::vector<std::uint8_t> seen(rgb.size() / 3);
    for (int y = 0; y < height; ++y) {
      fast.rows(y, y + 1, 0, width, rgb.data(), seen.data());
      for (int x = 0; x < width; ++x) {
        const Rgb light = reference.pixel(x, y).value_or(PixelLight{});
        const double difference = std::abs(double(rgb[3 * std::size_t(x)]) - light.r);
        QVERIFY(difference < 1e-3 || rays.isUnclear(x, y));
      }
    }
  }
}

/// JointProgress and their neighbours, of which a half more may be a whole number in single
/// precision.
void TestFastSimulation::roundsAsTheReference() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<float> values{std::numeric_limits<float>::quiet_NaN(), -infinity, infinity, 1e30F};
  for (int k = -2; k < 258; ++k)
    for (const float value : {float(k), float(k) + 0.5F})
      for (const float to : {-infinity, value, infinity})
        values.push_back(std::nextafter(value, to));
  std::vector<std::uint8_t> bytes(values.size());
  quantise(values.data(), int(values.size()), bytes.data());
  for (std::size_t k = 0; k < values.size(); ++k)
    QVERIFY2(bytes[k] == quantised(double(values[k])), qPrintable(QString::number(values[k])));
}

QTEST_APPLESS_MAIN(TestFastSimulation)
#include "test_fast_simulation.moc"
