// SPDX-License-Identifier: BSD-3-Clause
// Tests the reference engine against the brute-force simulator, pixel by pixel, on random scenes.
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/optics/simulate.h"
#include "tests/core/random_scene.h"

using namespace hogelscope;

namespace {

struct Counts {
  int compared = 0;
  int seen = 0;
  int unclear = 0;
};

/// Does a pixel hold this sum, rounded half up? Both neighbours are right near a half.
bool rounds(std::uint8_t pixel, double codeValue) {
  const double limited = std::clamp(codeValue, 0.0, 255.0);
  return std::abs(pixel - limited) <= 0.5 + 1e-6;
}

bool isPixel(const Image& image, std::size_t at, const brute::Simulator& expected,
             const brute::Vector& light) {
  for (std::size_t c = 0; c < 3; ++c)
    if (!rounds(image.rgb[3 * at + c], expected.encoded(light[c]))) return false;
  return true;
}

bool isBlack(const Image& image, std::size_t at) {
  return image.rgb[3 * at] == 0 && image.rgb[3 * at + 1] == 0 && image.rgb[3 * at + 2] == 0;
}

/// Names the first pixel that differs, or "".
QString firstDifference(const RandomScene& scene, Counts& counts) {
  const Image image = simulate(scene.job);
  const brute::Simulator expected(scene.job, scene.content);
  for (std::size_t at = 0; at < image.pixelCount(); ++at) {
    const int x = int(at) % image.width;
    const int y = int(at) / image.width;
    const brute::Ray ray = expected.ray(x, y);
    if (ray.meets == brute::Ray::Meets::unclear) {
      ++counts.unclear;
      continue;
    }
    ++counts.compared;
    const bool seen = ray.meets == brute::Ray::Meets::display;
    QString name = QString("pixel (%1, %2)").arg(x).arg(y);
    if (image.seen[at] != (seen ? 255 : 0)) return name + " of the mask";
    if (!seen && !isBlack(image, at)) return name + " is not black";
    if (!seen) continue;
    ++counts.seen;
    const auto& [i, j, u, v] = ray.hit;
    if (!isPixel(image, at, expected, expected.leaked(int(i), int(j), int(u), int(v)))) return name;
  }
  return {};
}

RandomScene sceneOf(std::uint64_t seed) {
  Random random(seed);
  return randomScene(random);
}

}  // namespace

class TestSimulate : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isTheBruteForceSimulator();
  void plainScenes();
  void eyeBehindSeesNothing_data();
  void eyeBehindSeesNothing();
  void extremeStatesGiveNumbers();
  void pixelAndRenderAgree();
  void badViewsAreRefused();
};

void TestSimulate::isTheBruteForceSimulator() {
  Counts counts;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const QString difference = firstDifference(sceneOf(seed), counts);
    QVERIFY2(difference.isEmpty(), qPrintable(QString("scene %1: ").arg(seed) + difference));
  }
  const QString found = QString("%1 compared, %2 seen, %3 unclear")
                            .arg(counts.compared)
                            .arg(counts.seen)
                            .arg(counts.unclear);
  QVERIFY2(counts.compared > 100000 && counts.seen > 30000 && counts.unclear < 2000,
           qPrintable(found));
}

/// No lens and no leakage: every pixel is a stored texel, to the last bit.
void TestSimulate::plainScenes() {
  Counts counts;
  for (std::uint64_t seed = 1000; seed < 1050; ++seed) {
    RandomScene scene = sceneOf(seed);
    scene.job.state.distortion = {};
    scene.job.state.psf = {0.67, 1};
    QCOMPARE(firstDifference(scene, counts), QString());
  }
  QVERIFY(counts.seen > 4000);
}

void TestSimulate::eyeBehindSeesNothing_data() {
  QTest::addColumn<double>("z");
  QTest::newRow("in the plane") << 0.0;
  QTest::newRow("just behind") << -1e-9;
  QTest::newRow("behind") << -1.0;
}

void TestSimulate::eyeBehindSeesNothing() {
  QFETCH(const double, z);
  RandomScene scene = sceneOf(5);
  scene.job.display.position = {0, 0, 0};
  scene.job.display.orientation = {0, 0, 0};
  for (const double lookatZ : {z - 1, z + 1}) {
    scene.job.state.camera.eye = {0, 0, z};
    scene.job.state.camera.lookat = {0, 0, lookatZ};
    const Image image = simulate(scene.job);
    QVERIFY(image == Image(image.width, image.height));
  }
}

void TestSimulate::extremeStatesGiveNumbers() {
  Random random(7);
  int seen = 0;
  for (int repeat = 0; repeat < 300; ++repeat) {
    RandomScene scene = randomScene(random);
    const auto pick = [&](double usual, double low, double high) {
      return random.flip() ? usual : random.flip() ? low : high;
    };
    auto& [camera, intrinsics, distortion, psf, pupil, stereo] = scene.job.state;
    if (random.flip()) intrinsics = {};
    camera.fov = pick(camera.fov, 0.01, 179.9);
    camera.eye.z = pick(camera.eye.z, -1e6, 1e6);
    distortion.k1 = pick(distortion.k1, -10, 10);
    distortion.p1 = pick(distortion.p1, -10, 10);
    psf.sigma = pick(psf.sigma, 1e-300, 20);
    scene.job.display.fov[0] = pick(scene.job.display.fov[0], 0.01, 179.9);
    scene.job.display.size[1] = pick(scene.job.display.size[1], 1e-6, 1e6);
    const Simulation simulation(scene.job);
    for (int k = 0; k < 60; ++k) {
      const auto colour = simulation.pixel(random.integer(0, camera.res[0] - 1),
                                           random.integer(0, camera.res[1] - 1));
      if (!colour) continue;
      ++seen;
      QVERIFY(std::isfinite(colour->r) && std::isfinite(colour->g) && std::isfinite(colour->b));
    }
  }
  QVERIFY(seen > 1000);
}

void TestSimulate::pixelAndRenderAgree() {
  const RandomScene scene = sceneOf(3);
  const Simulation simulation(scene.job);
  Image image(scene.job.state.camera.res[0], scene.job.state.camera.res[1]);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) simulation.render(x, y, image);
  QVERIFY(image == simulate(scene.job));
}

void TestSimulate::badViewsAreRefused() {
  RenderJob missing = sceneOf(3).job;
  missing.lightField = nullptr;
  QVERIFY_THROWS_EXCEPTION(InputError, Simulation{missing});
  RenderJob differs = sceneOf(3).job;
  ++differs.display.hogels[1];
  QVERIFY_THROWS_EXCEPTION(InputError, Simulation{differs});
  RenderJob noFrame = sceneOf(3).job;
  noFrame.state.camera.lookat = noFrame.state.camera.eye;
  QVERIFY_THROWS_EXCEPTION(InputError, Simulation{noFrame});
}

QTEST_APPLESS_MAIN(TestSimulate)
#include "test_simulate.moc"
