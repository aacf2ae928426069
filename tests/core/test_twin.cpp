// SPDX-License-Identifier: BSD-3-Clause
// Twins: the fast engine gives the reference's pixels, rays and their inverse agree, and a twin
// without errors changes no byte. test_footprint.cpp has views of twins too.
#include "core/panel/twin.h"

#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/engine/fast_simulation.h"
#include "core/engine/plan.h"
#include "tests/core/random_twin.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

RandomScene sceneOf(Random& random) {
  RandomScene scene = randomSampledScene(random);
  scene.job.display.hogels = {random.integer(3, 40), random.integer(3, 20)};
  scene.job.display.directions = {random.integer(3, 12), random.integer(3, 12)};
  fillDisplay(random, scene);
  if (random.flip()) scene.job.state.camera.res = {random.integer(130, 150), random.integer(5, 8)};
  return scene;
}

/// Whether a ray of the pixel meets the border of a cell, of the panel or of what sends light.
class Borders {
 public:
  explicit Borders(const RenderJob& job)
      : m_job(job),
        m_display(job.display, job.twin),
        m_camera(job.state.camera, job.state.intrinsics),
        m_distortion(job.state.distortion),
        m_samples(samplesOf(job.sampling.samplesPerPixel)) {
    for (const AperturePoint& point :
         apertureOf(job.state.pupil, job.state.camera, job.display, job.method.aperture).points)
      m_from.push_back(m_display.displayFromWorld() * fromPoint(m_camera.worldFromCamera(), point));
  }

  [[nodiscard]] bool isUnclear(int x, int y) const {
    for (const RaySample& sample : m_samples) {
      const Vec2 onSensor = m_camera.normalised(x + sample.place.x - 0.5, y + sample.place.y - 0.5);
      const auto ideal = idealPoint(m_distortion, m_job.sampling.mapping, onSensor);
      if (!ideal) continue;
      for (const RigidTransform& from : m_from)
        for (std::size_t channel = 0; channel < 3; ++channel) {
          const auto hit = m_display.intersectPlane(
              from.origin, from.direction({ideal->x, ideal->y, 1}), channel);
          if (hit && isNearBorder(*hit)) return true;
        }
    }
    return false;
  }

 private:
  [[nodiscard]] bool isNearBorder(const Hit& hit) const {
    const double near = m_from.size() > 1 ? 1e-3 : 1e-4;
    const auto& fill = m_job.twin->params().light.fill;
    const auto isNear = [near](double index, double part) {
      const double place = index - std::floor(index);
      return std::abs(place - std::round(place)) < near ||
             std::abs(2 * std::abs(place - 0.5) - part) < 2 * near;
    };
    return isNear(hit.i, 1) || isNear(hit.j, 1) || isNear(hit.u, fill[0]) || isNear(hit.v, fill[1]);
  }

  const RenderJob& m_job;
  Display m_display;
  Camera m_camera;
  Distortion m_distortion;
  std::vector<RaySample> m_samples;
  std::vector<RigidTransform> m_from;
};

bool agrees(std::uint8_t fast, double reference) {
  const std::uint8_t value = quantised(reference);
  return fast == value ||
         (std::abs(fast - value) == 1 && std::abs(reference - std::floor(reference) - 0.5) < 3e-3);
}

struct Counts {
  int seen = 0;
  int unclear = 0;
};

QString firstDifference(const RenderJob& job, const Image& fast, Counts& counts) {
  const Simulation reference(job);
  const Borders borders(job);
  for (std::size_t at = 0; at < fast.pixelCount(); ++at) {
    const int x = int(at) % fast.width;
    const int y = int(at) / fast.width;
    const std::optional<PixelLight> light = reference.pixel(x, y);
    const Rgb value = light.value_or(PixelLight{});
    counts.seen += light ? 1 : 0;
    const bool isEqual =
        fast.seen[at] == (light && light->isSeen ? 255 : 0) && agrees(fast.rgb[3 * at], value.r) &&
        agrees(fast.rgb[3 * at + 1], value.g) && agrees(fast.rgb[3 * at + 2], value.b);
    if (isEqual) continue;
    if (!borders.isUnclear(x, y))
      return QString("pixel (%1, %2): %3 %4 %5, reference %6 %7 %8, seen %9")
          .arg(x)
          .arg(y)
          .arg(fast.rgb[3 * at])
          .arg(fast.rgb[3 * at + 1])
          .arg(fast.rgb[3 * at + 2])
          .arg(value.r)
          .arg(value.g)
          .arg(value.b)
          .arg(fast.seen[at]);
    ++counts.unclear;
  }
  return {};
}

PanelParams plainDisplay() {
  PanelParams display;
  display.size = {0.08, 0.06};
  display.hogels = {80, 60};
  display.directions = {24, 24};
  display.fov = {40, 40};
  return display;
}

}  // namespace

class TestTwin : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isTheReference();
  void plainViewsAreTheReference();
  void outlinesAreTheReference();
  void raysAreInverse();
  void withoutErrorsNothingChanges();
  void foldingMapsAreRefused();
  void refusesWhatItCannotDo();
};

void TestTwin::isTheReference() {
  Counts counts;
  int pupils = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Random random(seed);
    RandomScene scene = sceneOf(random);
    if (random.integer(0, 4) == 0) {
      scene.job.state.pupil = {0.01 * scene.job.display.size[0], 0, 7};
      ++pupils;
    }
    addTwin(random, scene);
    const QString difference = firstDifference(scene.job, rendered(scene.job), counts);
    QVERIFY2(difference.isEmpty(), qPrintable(QString("seed %1: ").arg(seed) + difference));
  }
  QVERIFY2(counts.seen > 10000 && counts.unclear < counts.seen / 50 && pupils > 10,
           qPrintable(QString("%1 %2 %3").arg(counts.seen).arg(counts.unclear).arg(pupils)));
}

/// Views whose pixels are texels, which kernels of their own copy: twins with an affine map, hogels
/// and directions with errors, side lobes.
void TestTwin::plainViewsAreTheReference() {
  Counts counts;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    Random random(seed);
    RandomScene scene = sceneOf(random);
    RenderJob& job = scene.job;
    scene.content.codes.clear();
    fillWithNoise<std::uint8_t>(random, scene, 0, 256, 1);
    job.display.lens = HogelLensModel::rectilinear;
    job.sampling.reconstruction = Reconstruction::nearest;
    job.sampling.samplesPerPixel = 1;
    job.state.psf = {};
    job.state.camera.res = {random.integer(100, 300), random.integer(10, 20)};
    if (random.flip()) job.state.distortion = {};
    TwinParams params;
    params.lensArray = randomTwinParams(random, job.display).lensArray;
    params.lensArray.outside =
        random.integer(0, 3) == 0 ? OutsideField::neighbour : OutsideField::dark;
    if (random.flip()) params.lensArray.wedge = {};
    if (random.flip())
      params.random.shift.sigma = 0.1 * job.display.size[0] / job.display.hogels[0];
    TwinMaps maps = randomTwinMaps(random, job.display);
    for (TwinPlane* plane :
         {&maps.sigma, &maps.height, &maps.kernels[0], &maps.kernels[1], &maps.kernels[2]})
      *plane = {};
    if (random.flip()) maps.gap = {};
    if (random.flip()) maps.moveU = maps.moveV = {};
    job.twin = std::make_shared<const Twin>(params, maps, job.display);
    QVERIFY(plan(job).copiesTexels);
    const QString difference = firstDifference(job, rendered(job), counts);
    QVERIFY2(difference.isEmpty(), qPrintable(QString("seed %1: ").arg(seed) + difference));
  }
  QVERIFY2(counts.seen > 10000 && counts.unclear < counts.seen / 50,
           qPrintable(QString("%1 %2").arg(counts.seen).arg(counts.unclear)));
}

/// The ends of rows, at which hogels' shifts or the map of directions alone decide what is seen.
void TestTwin::outlinesAreTheReference() {
  Counts counts;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    RandomScene scene = sceneOf(random);
    RenderJob& job = scene.job;
    scene.content.codes.clear();
    fillWithNoise<std::uint8_t>(random, scene, 0, 256, 1);
    job.display.lens = HogelLensModel::rectilinear;
    for (double& fov : job.display.fov) fov *= 0.6;  // so that the field ends within the panel
    job.sampling = {};
    job.sampling.reconstruction = Reconstruction::nearest;
    job.state.psf = {};
    job.state.distortion = {};
    job.state.camera.res = {random.integer(200, 300), random.integer(10, 20)};
    TwinParams params;
    TwinMaps maps;
    if (random.flip()) {
      params.random.shift.sigma = 0.1 * job.display.size[0] / job.display.hogels[0];
    } else {
      const auto [du, dv] = job.display.directions;
      const double moved = random.uniform(-0.6, 0.6);
      maps.moveU = {du, dv, {}};
      maps.moveV = {du, dv, {}};
      for (int k = 0; k < du * dv; ++k) {
        maps.moveU.values.push_back(float(moved * (1 - 0.4 * (k % du))));
        maps.moveV.values.push_back(float(moved * (0.4 * (k / du) - 1)));
      }
    }
    job.twin = std::make_shared<const Twin>(params, maps, job.display);
    QVERIFY(plan(job).copiesTexels && job.twin->isAffine());
    const QString difference = firstDifference(job, rendered(job), counts);
    QVERIFY2(difference.isEmpty(), qPrintable(QString("seed %1: ").arg(seed) + difference));
  }
  QVERIFY2(counts.seen > 5000 && counts.unclear < counts.seen / 50,
           qPrintable(QString("%1 %2").arg(counts.seen).arg(counts.unclear)));
}

/// A ray that leaves a pixel's middle as one colour meets that pixel's middle.
void TestTwin::raysAreInverse() {
  int checked = 0;
  double worst = 0;
  for (std::uint64_t seed = 1; checked < 1500; ++seed) {
    Random random(seed);
    PanelParams display = plainDisplay();
    if (random.flip()) display.viewingDistance = 0.6;
    if (random.flip()) display.lens = HogelLensModel::equiangular;
    TwinParams params = randomTwinParams(random, display);
    params.lensArray.outside = OutsideField::dark;
    // At the panel's corners it would ask for angles beyond 90 degrees.
    if (display.lens == HogelLensModel::equiangular) params.lensArray.rotation = 0;
    TwinMaps maps = randomTwinMaps(random, display);
    maps.height = {};  // whose slope is another a little aside, see bends()
    const Twin twin(params, maps, display);
    for (int k = 0; k < 30; ++k) {
      const auto channel = std::size_t(random.integer(0, 2));
      const TexelIndex at{random.integer(0, 79), random.integer(0, 59), random.integer(0, 23),
                          random.integer(0, 23)};
      const PanelRay ray = twin.rayOf(at.i, at.j, at.u + 0.5, at.v + 0.5, channel);
      const double z = random.uniform(0.1, 0.5);
      const Vec3 eye{ray.position.x + z * ray.slopes.x, ray.position.y + z * ray.slopes.y, z};
      const auto hit = twin.meet(eye, {-ray.slopes.x, -ray.slopes.y, -1}, channel);
      QVERIFY(hit);
      QCOMPARE(int(std::floor(hit->i)), at.i);
      QCOMPARE(int(std::floor(hit->j)), at.j);
      worst = std::max({worst, std::abs(hit->u - at.u - 0.5), std::abs(hit->v - at.v - 0.5)});
      ++checked;
    }
  }
  QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
}

void TestTwin::withoutErrorsNothingChanges() {
  QVERIFY(TwinParams{}.isZero());
  TwinParams other;
  other.lensArray.outside = OutsideField::neighbour;
  QVERIFY(!other.isZero());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    RandomScene scene = sceneOf(random);
    const Image designed = rendered(scene.job);
    scene.job.twin = std::make_shared<const Twin>(TwinParams{}, TwinMaps{}, scene.job.display);
    QCOMPARE(rendered(scene.job), designed);
    QVERIFY(!Display(scene.job.display, scene.job.twin).traits().movesRays);
  }
}

void TestTwin::foldingMapsAreRefused() {
  const PanelParams display = plainDisplay();
  TwinMaps maps;
  maps.moveU = {24, 24, std::vector<float>(std::size_t(24) * 24)};
  maps.moveU.values[24 * 7 + 5] = 0.9F;
  (void)Twin({}, maps, display);
  maps.moveU.values[24 * 7 + 5] = 1.1F;  // beyond the next direction
  try {
    (void)Twin({}, maps, display);
    QFAIL("a folding map was taken");
  } catch (const InputError& error) {
    QVERIFY2(QString(error.what()).startsWith("twin.maps.directions: folds near direction (5, 7)"),
             error.what());
  }
}

void TestTwin::refusesWhatItCannotDo() {
  Random random(3);
  RandomScene scene = sceneOf(random);
  scene.job.sampling.reconstruction = Reconstruction::nearest;
  scene.job.state.psf.light = LightModel::encoded;
  TwinParams params;
  params.light.black = 0.01;
  scene.job.twin = std::make_shared<const Twin>(params, TwinMaps{}, scene.job.display);
  QVERIFY_EXCEPTION_THROWN((void)rendered(scene.job), InputError);
  QVERIFY_EXCEPTION_THROWN((void)simulate(scene.job), InputError);
  scene.job.state.psf.light = LightModel::linear;
  (void)rendered(scene.job);
  params = {};
  params.random.shift.sigma = 1e-5;
  scene.job.twin = std::make_shared<const Twin>(params, TwinMaps{}, scene.job.display);
  (void)rendered(scene.job);
  scene.job.sampling.reconstruction = Reconstruction::quadrilinear;
  QVERIFY_EXCEPTION_THROWN((void)rendered(scene.job), InputError);
  QVERIFY_EXCEPTION_THROWN((void)simulate(scene.job), InputError);
}

QTEST_GUILESS_MAIN(TestTwin)
#include "test_twin.moc"
