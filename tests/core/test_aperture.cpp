// SPDX-License-Identifier: BSD-3-Clause
// The pupil: its points, their number, and views through it, against closed forms, a brute-force
// sum over its points, and the pinholes that it is made of.
#include "core/optics/aperture.h"

#include <QTest>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/engine/ideal_view.h"
#include "core/engine/scaled_view.h"
#include "tests/core/live_content.h"
#include "tests/core/random_scene.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

/// The prototype's display: 96 × 96 hogels of 100 × 100 directions over 16°, seen from 0.4 m.
PanelParams prototypeDisplay() {
  PanelParams display;
  display.size = {0.096, 0.096};
  display.hogels = {96, 96};
  display.directions = {100, 100};
  display.fov = {16, 16};
  return display;
}

CameraParams inFront(double distance) {
  CameraParams camera;
  camera.eye = {0, 0, distance};
  return camera;
}

double linear(double code) {
  const double s = code / 255;
  return s > 0.04045 ? std::pow((s + 0.055) / 1.055, 2.4) : s / 12.92;
}

double code(double light) {
  return 255 * (light > 0.0031308 ? 1.055 * std::pow(light, 1 / 2.4) - 0.055 : 12.92 * light);
}

/// Returns the points of a pupil as the contract has them.
std::vector<brute::LensPoint> spiral(double diameter, double focus, int count) {
  std::vector<brute::LensPoint> points;
  for (int k = 0; k < count; ++k) {
    const double r = diameter / 2 * std::sqrt((k + 0.5) / count);
    points.push_back({r * std::cos(2.39996 * k), r * std::sin(2.39996 * k), focus});
  }
  return points;
}

/// A random scene with a pupil of a few directions and hogels.
RandomScene pupilScene(std::uint64_t seed) {
  Random random(seed);
  RandomScene scene = randomSampledScene(random);
  if (random.flip()) {
    scene.job.display.directions = {random.integer(9, 40), random.integer(9, 40)};
    fillDisplay(random, scene);
    scene.job.state.camera.res = {random.integer(130, 200), random.integer(2, 3)};
  }
  const double pitch = scene.job.display.size[0] / scene.job.display.hogels[0];
  const double focus = random.uniform(0.1, 4);
  scene.job.state.pupil = {random.uniform(0.01, 0.8) * pitch, focus, random.integer(1, 12)};
  return scene;
}

/// The light of one pixel through a pupil by brute force; unclear if rounding decides a ray.
struct Expected {
  brute::Vector light{};
  int seeing = 0;
  bool isUnclear = false;
};

/// Nearest reconstruction and one ray a pixel from each point.
Expected expectedLight(const RandomScene& scene, const brute::Simulator& brute, int x, int y) {
  const PupilParams& pupil = scene.job.state.pupil;
  Expected expected;
  for (const brute::LensPoint& point : spiral(pupil.diameter, pupil.focus, pupil.samples)) {
    const brute::Ray ray = brute.ray(x, y, point);
    if (ray.meets == brute::Ray::Meets::unclear) expected.isUnclear = true;
    if (ray.meets != brute::Ray::Meets::display) continue;
    ++expected.seeing;
    const auto& [i, j, u, v] = ray.hit;
    const brute::Vector light = brute.leaked(int(i), int(j), int(u), int(v));
    for (std::size_t c = 0; c < 3; ++c)
      expected.light[c] += linear(brute.encoded(light[c])) / pupil.samples;
  }
  for (double& channel : expected.light) channel = code(channel);
  return expected;
}

QString firstWrong(const RandomScene& scene, int& seen, int& partly) {
  const Simulation reference(scene.job);
  const brute::Simulator brute(scene.job, scene.content);
  const auto [width, height] = scene.job.state.camera.res;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Expected expected = expectedLight(scene, brute, x, y);
      if (expected.isUnclear) continue;
      const auto light = reference.pixel(x, y);
      const bool isAll = expected.seeing == scene.job.state.pupil.samples;
      seen += isAll ? 1 : 0;
      partly += !isAll && expected.seeing > 0 ? 1 : 0;
      const PixelLight found = light.value_or(PixelLight{{}, false});
      const std::array channels{found.r, found.g, found.b};
      double worst = 0;
      for (std::size_t c = 0; c < 3; ++c)
        if (expected.seeing > 0) worst = std::max(worst, std::abs(channels[c] - expected.light[c]));
      if (light.has_value() != (expected.seeing > 0) || found.isSeen != isAll || worst > 1e-6)
        return QString("pixel (%1, %2) is off by %3").arg(x).arg(y).arg(worst);
    }
  return {};
}

/// J1 by its integral, 1/π ∫ cos(t − x sin t) dt over 0 … π.
double bessel1(double x) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double t = std::numbers::pi * (k + 0.5) / steps;
    sum += std::cos(t - x * std::sin(t));
  }
  return sum / steps;
}

/// The contrast that is left of a grating of light 0.5 + 0.4 cos(2π frequency x) at a distance, in
/// row 0 of a view, and its part out of phase.
Vec2 contrastOf(const RenderJob& job, double frequency, double distance) {
  const FloatImage image = Renderer(serialRows).renderFloat(job);
  const int width = image.width;
  Vec2 contrast;
  for (int x = 0; x < width; ++x) {
    if (image.seen[std::size_t(x)] == 0) return {-1, -1};
    const double place = (x - (width - 1) / 2.0) / job.state.intrinsics.fx * distance;
    const double phase = 2 * std::numbers::pi * frequency * place;
    const double light = linear(double(image.rgb[3 * std::size_t(x)]));
    contrast.x += light * std::cos(phase) / (0.4 * width / 2);
    contrast.y += light * std::sin(phase) / (0.4 * width / 2);
  }
  return contrast;
}

/// The same by a closed form: 2 J1(v)/v, v = π ν A |1 − D/Φ|.
double airySum(double frequency, const PupilParams& pupil, double distance) {
  const double v =
      std::numbers::pi * frequency * pupil.diameter * std::abs(1 - distance / pupil.focus);
  return 2 * bessel1(v) / v;
}

QString wrongContrast(RenderJob job, double frequency, double distance) {
  for (const double diameter : {0.002, 0.004, 0.006, 0.008})
    for (const double focus : {0.4, 1.0}) {
      job.state.pupil = {diameter, focus, 1000};
      const Vec2 found = contrastOf(job, frequency, distance);
      const double expected = airySum(frequency, job.state.pupil, distance);
      if (std::abs(found.x - expected) > 0.005 || std::abs(found.y) > 0.005)
        return QString("A %1 focus %2: %3 and %4, not %5")
            .arg(diameter)
            .arg(focus)
            .arg(found.x)
            .arg(found.y)
            .arg(expected);
    }
  return {};
}

}  // namespace

class TestAperture : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pointsLieEvenlyInTheDisc_data();
  void pointsLieEvenlyInTheDisc();
  void countFollowsTheDisplay();
  void whatChangesNothingIsAPinhole();
  void focusOnThePanelIsItsDistance();
  void axisMustMeetThePanel();
  void referenceIsTheBruteForceSum();
  void fastEngineIsTheReference();
  void sumsPinholesOfShiftedIntrinsics();
  void focusOnOneDirectionIsThePinhole();
  void gratingsBlurByTheAirySum();
  void idealViewHasThePupil();
};

void TestAperture::pointsLieEvenlyInTheDisc_data() {
  QTest::addColumn<int>("pattern");
  QTest::addColumn<double>("tolerance");
  QTest::newRow("spiral") << int(AperturePattern::vogel) << 0.002;
  QTest::newRow("grid") << int(AperturePattern::grid) << 0.004;
  QTest::newRow("random") << int(AperturePattern::random) << 0.03;
}

/// The moments of a uniform disc of radius R: means 0, means of squares R²/4, of x y 0.
void TestAperture::pointsLieEvenlyInTheDisc() {
  QFETCH(const int, pattern);
  QFETCH(const double, tolerance);
  constexpr double diameter = 2;
  const std::vector<Vec2> points =
      discPoints(static_cast<AperturePattern>(pattern), diameter, 1500);
  QVERIFY(points.size() >= 1500 && points.size() < 1600);
  Vec2 mean;
  Vec2 squares;
  double product = 0;
  for (const auto& [x, y] : points) {
    QVERIFY(x * x + y * y <= 1);
    const auto n = double(points.size());
    mean = {mean.x + x / n, mean.y + y / n};
    squares = {squares.x + x * x / n, squares.y + y * y / n};
    product += x * y / n;
  }
  QVERIFY(std::abs(mean.x) < tolerance && std::abs(mean.y) < tolerance);
  QVERIFY(std::abs(squares.x - 0.25) < tolerance && std::abs(squares.y - 0.25) < tolerance);
  QVERIFY(std::abs(product) < tolerance);
}

/// The numbers of the measured convergence: K = 3.56, 51 points.
void TestAperture::countFollowsTheDisplay() {
  const PanelParams display = prototypeDisplay();
  const Aperture sharp = apertureOf({0.004, 0, 0}, inFront(0.4), display);
  const double step = 2 * std::tan(8 * brute::degree) / 100;
  QVERIFY(std::abs(sharp.directions - 0.004 / (0.4 * step)) < 0.001);
  QCOMPARE(sharp.hogels, 0.0);
  QCOMPARE(int(sharp.points.size()), 51);
  const Aperture behind = apertureOf({0.004, 0.5, 0}, inFront(0.4), display);
  QVERIFY(std::abs(behind.hogels - 0.004 * 0.2 / 0.001) < 1e-9);
  const double spread = sharp.directions + 0.8;
  QCOMPARE(int(behind.points.size()), int(std::ceil(4 * spread * spread)));
  QCOMPARE(int(apertureOf({0.004, 0.5, 7}, inFront(0.4), display).points.size()), 7);
  const Aperture wide = apertureOf({0.1, 0, 0}, inFront(0.4), display);
  QCOMPARE(int(wide.points.size()), 4096);
  QVERIFY(wide.wanted > 4096);
}

void TestAperture::whatChangesNothingIsAPinhole() {
  const PanelParams display = prototypeDisplay();
  QVERIFY(apertureOf({}, inFront(0.4), display).isPinhole);
  QVERIFY(apertureOf({1e-4, 0, 0}, inFront(0.4), display).isPinhole);
  QVERIFY(!apertureOf({1e-4, 0, 3}, inFront(0.4), display).isPinhole);
  QVERIFY(!apertureOf({1e-4, 0.1, 0}, inFront(0.4), display).isPinhole);
  RandomScene scene = pupilScene(3);
  scene.job.state.pupil = {};
  const Image pinhole = rendered(scene.job);
  scene.job.state.pupil = {1e-9, 0.5, 0};
  QCOMPARE(rendered(scene.job), pinhole);
}

void TestAperture::focusOnThePanelIsItsDistance() {
  PanelParams display = prototypeDisplay();
  display.position = {0.1, 0, -0.2};
  display.orientation = {0, 30, 0};
  CameraParams camera = inFront(0.5);
  // The plane through (0.1, 0, −0.2) with the normal (sin 30°, 0, cos 30°) meets the axis x = 0 at
  // z = −0.2 + 0.1 tan 30°.
  QVERIFY(std::abs(apertureOf({0.004, 0, 0}, camera, display).focus -
                   (0.7 - 0.1 * std::tan(30 * brute::degree))) < 1e-12);
}

void TestAperture::axisMustMeetThePanel() {
  CameraParams camera = inFront(0.4);
  camera.lookat = {1, 0, 0.4};
  QVERIFY_EXCEPTION_THROWN((void)apertureOf({0.004, 0, 0}, camera, prototypeDisplay()), InputError);
  QVERIFY(!apertureOf({0.004, 0.4, 0}, camera, prototypeDisplay()).isPinhole);
  QVERIFY(apertureOf({}, camera, prototypeDisplay()).isPinhole);
}

void TestAperture::referenceIsTheBruteForceSum() {
  int seen = 0;
  int partly = 0;
  for (std::uint64_t seed = 100; seed < 180; ++seed) {
    RandomScene scene = pupilScene(seed);
    scene.job.sampling.reconstruction = Reconstruction::nearest;
    scene.job.sampling.samplesPerPixel = 1;
    const QString wrong = firstWrong(scene, seen, partly);
    QVERIFY2(wrong.isEmpty(), qPrintable(QString("scene %1: ").arg(seed) + wrong));
  }
  QVERIFY2(seen > 4000 && partly > 400, qPrintable(QString("%1, %2").arg(seen).arg(partly)));
}

/// All mappings, reconstructions, leakages, types and lenses, several rays a pixel too.
void TestAperture::fastEngineIsTheReference() {
  int seen = 0;
  int unclear = 0;
  for (std::uint64_t seed = 1000; seed < 1150; ++seed) {
    const RandomScene scene = pupilScene(seed);
    const Simulation reference(scene.job);
    const brute::Simulator brute(scene.job, scene.content);
    const PupilParams& pupil = scene.job.state.pupil;
    const auto points = spiral(pupil.diameter, pupil.focus, pupil.samples);
    const FloatImage fast = Renderer(serialRows).renderFloat(scene.job);
    const Image image = rendered(scene.job);
    for (std::size_t at = 0; at < fast.seen.size(); ++at) {
      const int x = int(at) % fast.width;
      const int y = int(at) / fast.width;
      const auto light = reference.pixel(x, y);
      const PixelLight expected = light.value_or(PixelLight{{}, false});
      seen += expected.isSeen ? 1 : 0;
      const double error = std::max({std::abs(double(fast.rgb[3 * at]) - expected.r),
                                     std::abs(double(fast.rgb[3 * at + 1]) - expected.g),
                                     std::abs(double(fast.rgb[3 * at + 2]) - expected.b)});
      const bool isMask = (fast.seen[at] == 255) == expected.isSeen;
      if (isMask && error < 1e-3 && image.seen[at] == fast.seen[at]) {
        QVERIFY(image.rgb[3 * at] == quantised(double(fast.rgb[3 * at])));
        continue;
      }
      QVERIFY2(std::ranges::any_of(points,
                                   [&](const auto& point) { return brute.isUnclear(x, y, point); }),
               qPrintable(QString("scene %1 (%2, %3): %4").arg(seed).arg(x).arg(y).arg(error)));
      ++unclear;
    }
  }
  QVERIFY2(seen > 8000 && unclear < 60, qPrintable(QString("%1, %2").arg(seen).arg(unclear)));
}

/// A point of the pupil is a pinhole beside the eye whose principal point is shifted by f a/Φ.
void TestAperture::sumsPinholesOfShiftedIntrinsics() {
  RandomScene scene = pupilScene(42);
  RenderJob& job = scene.job;
  job.state.distortion = {};
  job.state.intrinsics = {};
  const double focus = job.state.pupil.focus;
  const FloatImage fast = Renderer(serialRows).renderFloat(job);
  const Camera camera(job.state.camera);
  std::vector<double> sums(fast.rgb.size());
  std::vector<int> seeing(fast.seen.size());
  const auto points = spiral(job.state.pupil.diameter, focus, job.state.pupil.samples);
  for (const auto& point : points) {
    RenderJob pinhole = job;
    pinhole.state.pupil = {};
    const Vec3 step =
        point.right * camera.worldFromCamera().xAxis + point.down * camera.worldFromCamera().yAxis;
    pinhole.state.camera.eye = job.state.camera.eye + step;
    pinhole.state.camera.lookat = job.state.camera.lookat + step;
    pinhole.state.intrinsics = {camera.focalLength().x, camera.focalLength().y,
                                camera.centre().x + camera.focalLength().x * point.right / focus,
                                camera.centre().y + camera.focalLength().y * point.down / focus};
    const FloatImage image = Renderer(serialRows).renderFloat(pinhole);
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += linear(double(image.rgb[k]));
    for (std::size_t k = 0; k < seeing.size(); ++k) seeing[k] += image.seen[k] == 255 ? 1 : 0;
  }
  int same = 0;
  for (std::size_t k = 0; k < sums.size(); ++k)
    same += std::abs(code(sums[k] / double(points.size())) - double(fast.rgb[k])) < 2e-3 ? 1 : 0;
  QVERIFY2(same > 0.998 * double(sums.size()), qPrintable(QString::number(same)));
  for (std::size_t k = 0; k < seeing.size(); ++k)
    QCOMPARE(fast.seen[k] == 255, seeing[k] == int(points.size()));
}

/// Focused on a panel whose hogels have one direction, all points see the same texel.
void TestAperture::focusOnOneDirectionIsThePinhole() {
  Random random(7);
  RandomScene scene;
  scene.job.display.size = {0.4, 0.3};
  scene.job.display.hogels = {40, 30};
  scene.job.display.directions = {1, 1};
  scene.job.display.fov = {90, 90};
  fillDisplay(random, scene);
  scene.job.state.camera = inFront(0.5);
  scene.job.state.camera.lookat = {};
  scene.job.state.camera.res = {90, 70};
  const Image pinhole = rendered(scene.job);
  scene.job.state.pupil = {0.006, 0, 40};
  const Image pupil = rendered(scene.job);
  int seen = 0;
  int differ = 0;
  for (std::size_t at = 0; at < pupil.pixelCount(); ++at) {
    if (pupil.seen[at] == 0) continue;
    ++seen;
    differ += std::equal(&pupil.rgb[3 * at], &pupil.rgb[3 * at + 3], &pinhole.rgb[3 * at]) ? 0 : 1;
  }
  QVERIFY2(seen > 1500, qPrintable(QString::number(seen)));
  // Where a pixel's middle is on a border of hogels, rounding decides.
  QVERIFY2(differ < 0.002 * seen, qPrintable(QString("%1 of %2").arg(differ).arg(seen)));
}

/// On the panel: the grating is the texels of hogels of one direction.
void TestAperture::gratingsBlurByTheAirySum() {
  constexpr int columns = 1600;
  constexpr double width = 0.2;
  constexpr double frequency = 50;
  RenderJob job;
  job.display.size = {width, 0.02};
  job.display.hogels = {columns, 4};
  job.display.directions = {1, 1};
  job.display.fov = {120, 120};
  std::vector<float> values;
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < columns; ++i) {
      const double x = width * ((i + 0.5) / columns - 0.5);
      const double light = 0.5 + 0.4 * std::cos(2 * std::numbers::pi * frequency * x);
      values.insert(values.end(), 3, float(code(light) / 255));
    }
  job.lightField = std::make_shared<LightField>(LightFieldSize{columns, 4, 1, 1}, values);
  job.state.camera = inFront(0.5);
  job.state.camera.res = {600, 1};  // 0.1 m on the panel, five periods
  job.state.intrinsics.fx = 3000;
  const QString wrong = wrongContrast(job, frequency, 0.5);
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

/// The grating is behind the panel, 0.7 m before the eye; the pixels' own width takes less than
/// 0.1 % of its contrast.
void TestAperture::idealViewHasThePupil() {
  constexpr double frequency = 40;
  RenderJob job;
  job.display.size = {0.3, 0.3};
  job.display.hogels = {10, 10};
  job.display.directions = {10, 10};
  job.display.fov = {120, 120};
  const auto grating = std::make_shared<LivePlanes>(std::vector<LivePlane>{
      {-0.2, [](double x, double) {
         return code(0.5 + 0.4 * std::cos(2 * std::numbers::pi * frequency * x));
       }}});
  job.lightField = liveSource(grating, job.display);
  job.isIdeal = true;
  job.state.camera = inFront(0.5);
  job.state.camera.res = {600, 1};
  job.state.intrinsics.fx = 600 * 0.7 / 0.125;  // five periods
  const QString wrong = wrongContrast(job, frequency, 0.7);
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

QTEST_APPLESS_MAIN(TestAperture)
#include "test_aperture.moc"
