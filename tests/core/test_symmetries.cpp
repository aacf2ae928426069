// SPDX-License-Identifier: BSD-3-Clause
// What changes a scene but not its image: another unit of length, a mirror, another place.
#include <QTest>
#include <cmath>

#include "tests/core/light.h"

using namespace hogelscope;
using extreme::Eye;

namespace {

constexpr std::array<Light (*)(const RenderJob&), 2> engines{referenceLight, fastLight};

RenderJob scaled(RenderJob job, double factor) {
  CameraParams& camera = job.state.camera;
  for (Vec3* length : {&job.display.position, &camera.eye, &camera.lookat})
    *length = factor * *length;
  for (double& size : job.display.size) size *= factor;
  job.display.viewingDistance *= factor;
  return job;
}

Vec3 mirrored(const Vec3& a) {
  return {-a.x, a.y, a.z};
}

/// At the world's plane x = 0, with red and blue swapped: rows backwards.
RandomScene mirrored(RandomScene scene, std::vector<std::uint8_t> values) {
  auto& [lightField, display, sampling, state, method, isIdeal, bits, keepsUnrounded, twin] =
      scene.job;
  auto& camera = state.camera;
  for (Vec3* point : {&display.position, &camera.eye, &camera.lookat, &camera.up})
    *point = mirrored(*point);
  display.orientation = -1.0 * mirrored(display.orientation);
  state.distortion.p2 = -state.distortion.p2;
  auto& cx = state.intrinsics.cx;
  if (cx != notGiven) cx = camera.res[0] - 1 - cx;
  const auto row = std::ptrdiff_t(3 * scene.content.size.width());
  for (auto at = values.begin(); at != values.end(); at += row) std::reverse(at, at + row);
  lightField = std::make_shared<LightField>(scene.content.size, std::move(values));
  return scene;
}

Light backwards(Light light, int width) {
  const std::ptrdiff_t values = std::ptrdiff_t(3) * width;
  for (auto at = light.rgb.begin(); at != light.rgb.end(); at += values)
    std::reverse(at, at + values);
  for (auto at = light.seen.begin(); at != light.seen.end(); at += width)
    std::reverse(at, at + width);
  return light;
}

/// Display and camera together, to where the display's frame is the world's.
RenderJob atOrigin(RenderJob job) {
  CameraParams& camera = job.state.camera;
  const brute::Matrix turn = brute::transposed(brute::rotation(job.display.orientation));
  const Vec3 centre = job.display.position;
  const auto turned = [&](const Vec3& a) {
    const auto [x, y, z] = brute::times(turn, brute::vector(a));
    return Vec3{x, y, z};
  };
  camera.eye = turned(camera.eye - centre);
  camera.lookat = turned(camera.lookat - centre);
  camera.up = turned(camera.up);
  job.display.position = job.display.orientation = {};
  return job;
}

}  // namespace

class TestSymmetries : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lengthsHaveNoUnit();
  void aMirrorMirrors();
  void onlyWhatIsRelativeCounts();
};

/// To the last bit: powers of two round nothing.
void TestSymmetries::lengthsHaveNoUnit() {
  for (int repeat = 0; repeat < 1500; ++repeat) {
    Random random(500000 + std::uint64_t(repeat));
    const RenderJob job = extreme::scene(random, static_cast<Eye>(random.integer(0, 7))).job;
    const RenderJob other = scaled(job, std::ldexp(1, random.integer(-20, 20)));
    for (const auto& engine : engines)
      QVERIFY2(engine(job) == engine(other), qPrintable(QString("scene %1").arg(repeat)));
  }
}

void TestSymmetries::aMirrorMirrors() {
  int unclear = 0;
  for (int repeat = 0; repeat < 1500; ++repeat) {
    Random random(600000 + std::uint64_t(repeat));
    RandomScene scene = extreme::sceneWithoutLight(random, static_cast<Eye>(random.integer(0, 7)));
    std::vector<std::uint8_t> values(3 * scene.content.size.width() * scene.content.size.height());
    for (std::uint8_t& value : values) value = std::uint8_t(random.integer(0, 255));
    scene.job.lightField = std::make_shared<LightField>(scene.content.size, values);
    const RenderJob other = mirrored(scene, values).job;
    for (const auto& engine : engines) {
      const Light found = backwards(engine(other), other.state.camera.res[0]);
      const Problem problem = difference(scene, engine(scene.job), found, unclear);
      QVERIFY2(problem.isEmpty(), qPrintable(QString("scene %1: ").arg(repeat) + problem));
    }
  }
  QVERIFY2(unclear < 30, qPrintable(QString::number(unclear)));
}

void TestSymmetries::onlyWhatIsRelativeCounts() {
  int unclear = 0;
  for (int repeat = 0; repeat < 300; ++repeat) {
    Random random(700000 + std::uint64_t(repeat));
    RandomScene scene = randomScene(random);
    scene.job.sampling = extreme::sampling(random);
    extreme::limitWork(random, scene.job);
    for (const auto& engine : engines) {
      const Problem problem =
          difference(scene, engine(scene.job), engine(atOrigin(scene.job)), unclear);
      QVERIFY2(problem.isEmpty(), qPrintable(QString("scene %1: ").arg(repeat) + problem));
    }
  }
  QVERIFY2(unclear < 30, qPrintable(QString::number(unclear)));
}

QTEST_APPLESS_MAIN(TestSymmetries)
#include "test_symmetries.moc"
