// SPDX-License-Identifier: BSD-3-Clause
// Tests interpolation between directional pixels and hogels, and several rays in a pixel.
#include <QTest>
#include <cmath>

#include "core/optics/simulate.h"
#include "tests/core/random_scene.h"

using namespace hogelscope;

namespace {

/// A channel's light, affine in the cells' real-valued indices, whole at the cells' middles.
double affine(std::size_t channel, const std::array<double, 4>& at) {
  static constexpr std::array<std::array<int, 4>, 3> slopes{
      {{5, 6, 3, 2}, {-6, 4, -1, 8}, {0, -9, 6, -5}}};
  double value = 120;
  for (std::size_t axis = 0; axis < 4; ++axis) value += slopes[channel][axis] * (at[axis] - 0.5);
  return value;
}

void fillWithAffineLight(RandomScene& scene) {
  const auto& [nx, ny, du, dv] = scene.content.size;
  std::vector<std::uint8_t> values;
  for (int row = 0; row < ny * dv; ++row)
    for (int column = 0; column < nx * du; ++column)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::array<int, 4> index{column / du, row / dv, column % du, row % dv};
        values.push_back(static_cast<std::uint8_t>(
            affine(c, {index[0] + 0.5, index[1] + 0.5, index[2] + 0.5, index[3] + 0.5})));
      }
  scene.job.lightField = std::make_shared<LightField>(scene.content.size, std::move(values));
}

/// The index between the outermost cells' middles nearest to a hit's.
double towardsMiddles(double index, int count) {
  return std::clamp(index, 0.5, count - 0.5);
}

std::array<double, 4> interpolated(Reconstruction how, std::array<double, 4> hit,
                                   const LightFieldSize& size) {
  const std::array<int, 4> counts{size.nx, size.ny, size.du, size.dv};
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const bool isHogel = axis < 2;
    const bool whole =
        how == Reconstruction::nearest || (isHogel && how == Reconstruction::bilinear);
    hit[axis] = whole ? std::floor(hit[axis]) + 0.5 : towardsMiddles(hit[axis], counts[axis]);
  }
  return hit;
}

double difference(const Rgb& a, const brute::Vector& b) {
  return std::max({std::abs(a.r - b[0]), std::abs(a.g - b[1]), std::abs(a.b - b[2])});
}

/// The mean of a pixel's n×n rays; unclear where one of them is, or none meets the display.
struct Mean {
  bool unclear = false;
  bool seen = false;
  brute::Vector light{};
};

Mean meanOfRays(const brute::Simulator& simulator, int x, int y, int n) {
  Mean mean;
  for (int k = 0; k < n * n; ++k) {
    // The middles of n×n equal squares of the pixel, which reaches from -1/2 to 1/2.
    const int column = k % n;
    const int row = k / n;
    const double px = x + (2 * column + 1 - n) / (2.0 * n);
    const double py = y + (2 * row + 1 - n) / (2.0 * n);
    const brute::Ray ray = simulator.ray(px, py);
    mean.unclear = mean.unclear || ray.meets == brute::Ray::Meets::unclear;
    if (ray.meets != brute::Ray::Meets::display) continue;
    mean.seen = true;
    const auto& [i, j, u, v] = ray.hit;
    const brute::Vector light = simulator.leaked(int(i), int(j), int(u), int(v));
    for (std::size_t c = 0; c < 3; ++c) mean.light[c] += light[c] / (n * n);
  }
  for (double& channel : mean.light) channel = simulator.encoded(channel);
  return mean;
}

}  // namespace

class TestReconstruction : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void affineLightIsKept_data();
  void affineLightIsKept();
  void leaksBeforeItInterpolates();
  void samplesAreTheMeanOfRays_data();
  void samplesAreTheMeanOfRays();
};

void TestReconstruction::affineLightIsKept_data() {
  QTest::addColumn<int>("how");
  QTest::newRow("nearest") << int(Reconstruction::nearest);
  QTest::newRow("bilinear") << int(Reconstruction::bilinear);
  QTest::newRow("quadrilinear") << int(Reconstruction::quadrilinear);
}

void TestReconstruction::affineLightIsKept() {
  QFETCH(const int, how);
  Random random(1);
  int seen = 0;
  for (int repeat = 0; repeat < 60; ++repeat) {
    RandomScene scene = randomScene(random);
    fillWithAffineLight(scene);
    scene.job.state.psf = {0.67, 1};
    scene.job.sampling.reconstruction = static_cast<Reconstruction>(how);
    const brute::Simulator expected(scene.job, scene.content);
    const Simulation simulation(scene.job);
    const auto [width, height] = scene.job.state.camera.res;
    for (int k = 0; k < width * height; ++k) {
      const int y = k / width;
      const brute::Ray ray = expected.ray(k % width, y);
      if (ray.meets != brute::Ray::Meets::display) continue;
      const auto at = interpolated(static_cast<Reconstruction>(how), ray.hit, scene.content.size);
      const auto colour = simulation.pixel(k % width, k / width);
      QVERIFY(colour);
      QVERIFY(difference(*colour, {affine(0, at), affine(1, at), affine(2, at)}) < 1e-8);
      ++seen;
    }
  }
  QVERIFY(seen > 5000);
}

/// One hogel, two directions, light summed linearly: the interpolated value is the mean of the two
/// leaked ones, encoded last.
void TestReconstruction::leaksBeforeItInterpolates() {
  RenderJob job;
  job.display.hogels = {1, 1};
  job.display.directions = {2, 1};
  job.lightField = std::make_shared<LightField>(LightFieldSize{1, 1, 2, 1},
                                                std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255});
  job.state.camera.res = {1, 1};
  job.state.psf = {1, 3, PsfBorder::black, LightModel::linear};
  job.sampling.reconstruction = Reconstruction::bilinear;
  const double w = std::exp(-0.5);
  const double kept = 1 / ((1 + 2 * w) * (1 + 2 * w));  // a texel's own share of the window
  const double light = (kept + w * kept) / 2;
  const double code = 255 * (1.055 * std::pow(light, 1 / 2.4) - 0.055);
  QVERIFY(difference(*Simulation(job).pixel(0, 0), {code, code, code}) < 1e-10);
}

void TestReconstruction::samplesAreTheMeanOfRays_data() {
  QTest::addColumn<int>("n");
  for (const int n : {1, 2, 3, 4}) QTest::addRow("%d", n) << n;
}

void TestReconstruction::samplesAreTheMeanOfRays() {
  QFETCH(const int, n);
  Random random(2);
  int compared = 0;
  int seen = 0;
  for (int repeat = 0; repeat < 15; ++repeat) {
    RandomScene scene = randomScene(random);
    scene.job.sampling.samplesPerPixel = n;
    const brute::Simulator simulator(scene.job, scene.content);
    const Simulation simulation(scene.job);
    const auto [width, height] = scene.job.state.camera.res;
    for (int k = 0; k < width * height; ++k) {
      const Mean expected = meanOfRays(simulator, k % width, k / width, n);
      if (expected.unclear) continue;
      ++compared;
      const auto colour = simulation.pixel(k % width, k / width);
      QCOMPARE(colour.has_value(), expected.seen);
      if (!colour) continue;
      ++seen;
      QVERIFY(difference(*colour, expected.light) < 1e-8);
    }
  }
  QVERIFY2(compared > 4000 && seen > 1200, qPrintable(QString::number(seen)));
}

QTEST_APPLESS_MAIN(TestReconstruction)
#include "test_reconstruction.moc"
