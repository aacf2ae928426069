// SPDX-License-Identifier: BSD-3-Clause
// The panel's own image: each of its pixels is the ray from the eye to that place of the panel.
#include <QtTest>

#include "core/optics/pixel_inspection.h"
#include "core/optics/scene_eyes.h"
#include "tests/core/random_scene.h"

using namespace hogelscope;

class TestPanelView : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aPixelIsAPlaceOfThePanel() {
    Random random(5);
    int seen = 0;
    for (int k = 0; k < 200; ++k) {
      RandomScene scene = randomScene(random);
      const PanelParams& display = scene.job.display;
      const Vec3 eye = scene.job.state.camera.eye;
      const std::array<int, 2> res{random.integer(1, 40), random.integer(1, 40)};
      const auto state = panelState(display, eye, res);
      QVERIFY(state.has_value());
      scene.job.state = *state;
      scene.job.sampling.mapping = LensMapping::exact;
      const int x = random.integer(0, res[0] - 1);
      const int y = random.integer(0, res[1] - 1);
      const PixelTrace pixel = pixelTrace(scene.job, x, y);
      QVERIFY(pixel.place.has_value());
      QVERIFY(pixel.end != RayEnd::misses);
      QVERIFY(std::abs(pixel.place->i - (x + 0.5) / res[0] * display.hogels[0]) < 1e-6);
      QVERIFY(std::abs(pixel.place->j - (y + 0.5) / res[1] * display.hogels[1]) < 1e-6);
      QVERIFY(length(pixel.eye - eye) < 1e-12);
      if (pixel.end == RayEnd::seen) ++seen;
    }
    QVERIFY(seen > 50);
  }

  void thereIsNoneFromBehind() {
    QVERIFY(!panelState({}, {0, 0, -0.1}, {4, 4}));
    QVERIFY(!panelState({}, {0, 0, 0}, {4, 4}));
    QVERIFY(panelState({}, {3, 2, 1e-9}, {4, 4}));
  }

  /// Nor from beside the angular field; its pixels are as small as asked for, but not too many.
  void aLitPanelHasThePixelsOfTheScreen() {
    PanelParams display;
    display.size = {0.4, 0.2};
    display.fov = {60, 60};
    const auto res = [&](double pixel, int longest) {
      return litPanelState(display, {0, 0, 1}, pixel, longest)->camera.res;
    };
    QVERIFY(res(0.01, 100) == (std::array{40, 20}));
    QVERIFY(res(0.001, 100) == (std::array{100, 100}));
    QVERIFY(res(1, 100) == (std::array{1, 1}));
    QVERIFY(panelState(display, {3, 0, 1}, {4, 4}));
    QVERIFY(!litPanelState(display, {3, 0, 1}, 0.01, 100));
  }

  /// Against vectors of the world, without the display frame.
  void whereAnEyeIs() {
    const EyePlace left = eyePlaceOf({}, {-0.3, 0.4, 0.3});
    QVERIFY(std::abs(left.distance - std::sqrt(0.34)) < 1e-12 &&
            std::abs(left.across + 45) < 1e-12);
    QCOMPARE(eyePlaceOf({}, {0, 0.1, 0.5}).across, 0.0);
    Random random(11);
    for (int k = 0; k < 100; ++k) {
      const PanelParams display = randomDisplay(random);
      const RigidTransform world = transformFromPose(display.position, display.orientation);
      const Vec3 p{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
      const Vec3 flat = p - display.position - dot(p - display.position, world.yAxis) * world.yAxis;
      const double cosine = dot(flat, world.zAxis) / length(flat);
      const EyePlace place = eyePlaceOf(display, p);
      QVERIFY(std::abs(std::cos(place.across * std::acos(-1.0) / 180) - cosine) < 1e-9);
      QCOMPARE(place.across > 0, dot(flat, world.xAxis) > 0);
      QVERIFY(std::abs(place.distance - length(p - display.position)) < 1e-12);
    }
  }

  void distanceIsToTheNearestPlace() {
    Random random(9);
    for (int k = 0; k < 100; ++k) {
      const PanelParams display = randomDisplay(random);
      const RigidTransform world = transformFromPose(display.position, display.orientation);
      const Vec3 p{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
      double least = 1e9;
      constexpr int n = 200;
      for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x)
          least = std::min(least,
                           length(p - world.point({(double(x) / n - 0.5) * display.size[0],
                                                   (double(y) / n - 0.5) * display.size[1], 0})));
      const double distance = distanceToPanel(display, p);
      QVERIFY(distance <= least + 1e-9 && least - distance < 2.0 / n);
    }
  }
};

QTEST_APPLESS_MAIN(TestPanelView)
#include "test_panel_view.moc"
