// SPDX-License-Identifier: BSD-3-Clause
// Simulated contrast against its law, over random displays, depths, leakage and pupils; the law
// against numbers that were measured with other code.
#include "measure/contrast.h"

#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

using namespace hogelscope;

namespace {

/// The display of the research that the law comes from: 0.5 mm hogels, 48 directions over 30°.
PanelParams smallPitch() {
  PanelParams display;
  display.size = {0.08, 0.08};
  display.hogels = {160, 160};
  display.directions = {48, 48};
  display.fov = {30, 30};
  return display;
}

CameraState stateAt(const Vec3& eye) {
  CameraState state;
  state.camera.name = "eye";
  state.camera.eye = eye;
  return state;
}

bool isNear(double a, double b, double by) {
  return std::abs(a - b) <= by;
}

QString both(double a, double b) {
  return QString::number(a) + " " + QString::number(b);
}

}  // namespace

class TestContrast : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Values of another program's law and measurement (numpy), pupil 6 mm, z = −40 mm, 0.2 c/mm.
  void lawOfAPupil() {
    CameraState state = stateAt({0, 0, 0.5});
    state.pupil.diameter = 0.006;
    state.pupil.samples = 120;
    const std::array<std::pair<double, double>, 4> cases{
        {{0.54, 0.971}, {0.50, 0.960}, {0.45, 0.903}, {0.60, 0.954}}};
    for (const auto& [focus, expected] : cases) {
      state.pupil.focus = focus;
      Bench bench(smallPitch(), state);
      QVERIFY2(isNear(contrastLaw(bench, {200, -0.04}, 0), expected, 6e-4),
               qPrintable(both(contrastLaw(bench, {200, -0.04}, 0), expected)));
      QVERIFY(isNear(contrast(bench, {200, -0.04}, 0), expected, 3e-3));
    }
  }

  void simulatedIsTheLaw_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 0; seed < 12; ++seed) QTest::addRow("%d", seed) << seed;
  }

  void simulatedIsTheLaw() {
    QFETCH(int, seed);
    std::mt19937 random{unsigned(seed)};
    const auto uniform = [&](double low, double high) {
      return std::uniform_real_distribution(low, high)(random);
    };
    PanelParams display;
    display.size = {uniform(0.1, 0.6), uniform(0.1, 0.6)};
    display.hogels = {int(uniform(40, 300)), int(uniform(40, 300))};
    display.directions = {int(uniform(8, 60)), int(uniform(8, 60))};
    display.fov = {uniform(30, 80), uniform(30, 80)};
    display.position = {1, 2, 3};  // where it stands makes no difference
    display.orientation = {10, 20, 30};
    if (seed % 3 == 0) display.viewingDistance = uniform(0.4, 2);
    const double distance = uniform(0.4, 1);
    const Vec3 eye{uniform(-0.05, 0.05), uniform(-0.05, 0.05), distance};
    const RigidTransform pose = transformFromPose(display.position, display.orientation);
    CameraState state = stateAt(pose.point(eye));
    if (seed % 2 == 0) {
      state.psf.windowSize = 5;
      state.psf.sigma = uniform(0.3, 1.2);
      state.psf.light = seed % 4 == 0 ? LightModel::linear : LightModel::encoded;
    }
    if (seed % 5 == 0) {
      state.pupil.diameter = 0.004;
      state.pupil.focus = uniform(0.8, 1.2) * distance;
      state.pupil.samples = 200;
    }
    Bench bench(display, state);
    for (const std::size_t axis : {0, 1}) {
      const double scale = bench.pitch(axis) / bench.step(axis);
      for (const double depth : {-0.9, -0.3, 0.0, 0.4}) {
        if (depth * scale > 0.7 * distance) continue;
        const Grating grating{uniform(0.1, 0.9) / bench.pitch(axis), depth * scale};
        const double law = contrastLaw(bench, grating, axis);
        const double simulated = contrast(bench, grating, axis);
        QVERIFY2(isNear(simulated, law, 0.012), qPrintable(both(simulated, law)));
      }
    }
  }

  /// The lens that is even in angle has no law; its contrast falls where its steps are wider.
  void ofAnotherLens() {
    PanelParams display = smallPitch();
    display.lens = HogelLensModel::equiangular;
    Bench bench(display, stateAt({0, 0, 0.5}));
    QVERIFY(!bench.isLinear(0));
    const double simulated = contrast(bench, {400, -0.03}, 0);
    QVERIFY2(isNear(simulated, contrastLaw(bench, {400, -0.03}, 0), 0.03),
             qPrintable(QString::number(simulated)));
  }

  void falls() {
    const auto sinc = [](double x) { return x == 0 ? 1 : std::sin(x) / x; };
    QVERIFY(isNear(depthOfFall(sinc, 0.5, 1), 1.895494, 1e-5));
    QVERIFY(isNear(depthOfFall(sinc, 0, 1), std::numbers::pi, 1e-5));
    QVERIFY(std::isinf(depthOfFall([](double) { return 1.0; }, 0.5, 1)));
  }

  void eyeBehindThePanel() {
    QVERIFY_EXCEPTION_THROWN(Bench(smallPitch(), stateAt({0, 0, -1})), InputError);
  }

  /// A line of the panel, from an eye that stands aside, against the display's own geometry.
  void looking() {
    PanelParams display = smallPitch();
    Bench bench(display, stateAt({0.01, 0.02, 0.5}));
    const TestLight places = [](const plugin::Ray& ray) {
      const Vec2 point = pointOf(ray, 0);
      return grey(1000 * (point.x + 0.05) + 1e-3 * (point.y + 0.05));
    };
    const auto points = bench.look(places, bench.eye(), 0, -0.04, 0.04, 391, 0.0101);
    QCOMPARE(points.size(), std::size_t(391));
    for (const BenchPoint& point : points) {
      const double hogel = std::floor((point.place / 0.08 + 0.5) * 160);
      const double x = 0.08 * ((hogel + 0.5) / 160 - 0.5);
      const double y = 0.08 * ((std::floor((0.0101 / 0.08 + 0.5) * 160) + 0.5) / 160 - 0.5);
      QVERIFY2(isNear(point.values[0], 1000 * (x + 0.05) + 1e-3 * (y + 0.05), 1e-4),
               qPrintable(QString::number(point.place)));
      const double slope = (0.01 - point.place) / 0.5;
      const double half = std::tan(15 * std::numbers::pi / 180);
      QVERIFY(isNear(point.direction, 48 * (0.5 + slope / (2 * half)), 1e-9));
    }
    const auto down = bench.look(places, bench.eye(), 1, -0.04, 0.04, 7, 0);
    QCOMPARE(down.size(), std::size_t(7));
    QVERIFY(down[0].place < down[6].place && down[0].values[0] < down[6].values[0]);
  }
};

QTEST_GUILESS_MAIN(TestContrast)
#include "test_contrast.moc"
