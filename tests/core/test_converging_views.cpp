// SPDX-License-Identifier: BSD-3-Clause
// Tests light fields of cameras that stood on a plane and looked at all of the panel: a camera at
// the place of a view sees that view's image, whole and exact, and live content through them.
#include <QTest>
#include <cmath>

#include "core/optics/simulate.h"
#include "tests/core/live_content.h"
#include "tests/core/random_scene.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

PanelParams convergingDisplay() {
  PanelParams display;
  display.size = {0.4, 0.3};
  display.hogels = {36, 25};
  display.directions = {7, 5};
  display.fov = {40, 30};
  display.viewingDistance = 0.9;
  return display;
}

/// Looks straight ahead from where the camera of view (u, v) stood, with a pixel for each hogel.
CameraState cameraOfView(const PanelParams& display, int u, int v) {
  const double distance = display.viewingDistance;
  const auto coordinate = [&](int k, int count, double fov) {
    const double part = (k + 0.5) / count - 0.5;
    return distance * (display.lens == HogelLensModel::equiangular
                           ? std::tan(part * fov * brute::degree)
                           : 2 * part * std::tan(fov / 2 * brute::degree));
  };
  const double x = coordinate(u, display.directions[0], display.fov[0]);
  const double y = -coordinate(v, display.directions[1], display.fov[1]);
  CameraState state;
  state.camera.eye = {x, y, distance};
  state.camera.lookat = {x, y, 0};
  state.camera.res = display.hogels;
  const auto& [width, height] = display.size;
  const auto& [nx, ny] = display.hogels;
  state.intrinsics.fx = nx * distance / width;
  state.intrinsics.fy = ny * distance / height;
  state.intrinsics.cx = (nx - 1) / 2.0 + nx * x / width;
  state.intrinsics.cy = (ny - 1) / 2.0 - ny * y / height;
  return state;
}

}  // namespace

class TestConvergingViews : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aCameraSeesItsView_data();
  void aCameraSeesItsView();
  void pointsStayTogether();
};

void TestConvergingViews::aCameraSeesItsView_data() {
  QTest::addColumn<int>("lens");
  QTest::newRow("rectilinear") << int(HogelLensModel::rectilinear);
  QTest::newRow("equiangular") << int(HogelLensModel::equiangular);
}

void TestConvergingViews::aCameraSeesItsView() {
  QFETCH(int, lens);
  Random random(5);
  RandomScene scene;
  scene.job.display = convergingDisplay();
  fillDisplay(random, scene);
  scene.job.display.lens = HogelLensModel(lens);
  const auto [nx, ny] = scene.job.display.hogels;
  const auto [du, dv] = scene.job.display.directions;
  for (int v = 0; v < dv; ++v)
    for (int u = 0; u < du; ++u) {
      scene.job.state = cameraOfView(scene.job.display, u, v);
      const Image fast = rendered(scene.job);
      QVERIFY(fast == simulate(scene.job));
      for (int k = 0; k < nx * ny; ++k) {
        QCOMPARE(fast.seen[std::size_t(k)], std::uint8_t{255});
        const Rgb texel = scene.job.lightField->texel({k % nx, k / nx, u, v});
        QCOMPARE(fast.rgb[std::size_t(3 * k)], quantised(texel.r));
        QCOMPARE(fast.rgb[std::size_t(3 * k) + 2], quantised(texel.b));
      }
    }
}

/// Live content: a bar behind the panel is where a pinhole at the eye projects it, for eyes at the
/// viewing distance, nearer and farther.
void TestConvergingViews::pointsStayTogether() {
  PanelParams display = convergingDisplay();
  display.hogels = {200, 3};
  display.directions = {400, 3};
  constexpr double depth = -0.15;
  const auto bar = [](double x, double) { return std::abs(x - 0.02) < 0.005 ? 200.0 : 10.0; };
  RenderJob job;
  job.display = display;
  job.lightField =
      liveSource(std::make_shared<LivePlanes>(std::vector<LivePlane>{{depth, bar}}), display);
  for (const double z : {0.9, 0.5, 1.6}) {
    CameraState& state = job.state;
    state.camera.eye = {0.05, 0, z};
    state.camera.lookat = {0.05, 0, 0};
    state.camera.res = {401, 5};
    state.camera.fov = 1;
    state.intrinsics.fx = state.intrinsics.fy = 500 * z;
    const Image image = rendered(job);
    double sum = 0;
    double moment = 0;
    for (int x = 0; x < 401; ++x)
      if (const auto pixel = std::size_t(2 * 401 + x); image.rgb[3 * pixel] == 200) {
        sum += 1;
        moment += x;
      }
    QVERIFY(sum > 0);
    const double expected = 200 + 500 * z * (0.02 - 0.05) / (z - depth);
    QVERIFY2(std::abs(moment / sum - expected) < 1.5,
             qPrintable(QString("%1: %2, %3").arg(z).arg(moment / sum).arg(expected)));
  }
}

QTEST_APPLESS_MAIN(TestConvergingViews)
#include "test_converging_views.moc"
