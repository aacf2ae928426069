// SPDX-License-Identifier: BSD-3-Clause
// Tests the size of a pixel as the eye sees it, in the middle of the image, against closed forms
// and against angles between the rays of neighbouring pixels.
#include <QTest>
#include <cmath>
#include <numbers>

#include "core/optics/simulate.h"
#include "core/optics/viewing.h"

using namespace hogelscope;

namespace {

constexpr double degree = std::numbers::pi / 180;

CameraState stateOf(double fov, std::array<int, 2> res) {
  CameraState state;
  state.camera.fov = fov;
  state.camera.res = res;
  return state;
}

double pixelsPerDegree(const CameraState& state, LensMapping mapping = LensMapping::exact) {
  return viewingOf(state, {}, mapping).pixelsPerDegree;
}

/// Of the solid angle of a hundredth of a pixel's sides in the image's middle.
double measured(const CameraState& state, LensMapping mapping) {
  const Camera camera(state.camera, state.intrinsics);
  const Distortion lens(state.distortion);
  const auto [width, height] = state.camera.res;
  const auto ray = [&](double dx, double dy) {
    const auto p = idealPoint(lens, mapping,
                              camera.normalised((width - 1) / 2.0 + dx, (height - 1) / 2.0 + dy));
    return normalise(Vec3{p->x, p->y, 1});
  };
  constexpr double step = 0.005;
  const Vec3 across = ray(step, 0) - ray(-step, 0);
  const Vec3 down = ray(0, step) - ray(0, -step);
  return degree * 2 * step / std::sqrt(length(cross(across, down)));
}

}  // namespace

class TestViewing : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// On the axis a pixel is 1/f wide; the first has FLIP's 67.02 of a screen 0.7 m wide and away.
  void ofAPinhole() {
    const double fov = 2 * std::atan(0.5 * 2160 / 3840.0) / degree;
    QVERIFY(std::abs(pixelsPerDegree(stateOf(fov, {3840, 2160})) - 3840 * degree) < 1e-9);
    CameraState state = stateOf(60, {640, 480});
    QVERIFY(std::abs(pixelsPerDegree(state) - degree * 240 / std::tan(30 * degree)) < 1e-12);
    state.intrinsics = {.fx = 400, .fy = 900};
    QVERIFY(std::abs(pixelsPerDegree(state) - degree * 600) < 1e-12);
  }

  /// Beside the axis a flat image's pixels are smaller, by the cosine to the power of 3/2.
  void besideTheAxis() {
    CameraState state = stateOf(60, {601, 401});
    state.intrinsics = {.fx = 500, .fy = 500, .cx = 300 - 500 * std::tan(40 * degree), .cy = 200};
    const double expected = degree * 500 / std::pow(std::cos(40 * degree), 1.5);
    QVERIFY(std::abs(pixelsPerDegree(state) - expected) < 1e-9);
  }

  /// A lens changes no size on its axis, and that of its Jacobian elsewhere.
  void throughALens() {
    for (const LensMapping mapping : {LensMapping::exact, LensMapping::direct}) {
      CameraState state = stateOf(50, {500, 300});
      const double without = pixelsPerDegree(state, mapping);
      state.distortion = {.k1 = -0.2, .k2 = 0.05};
      QVERIFY(std::abs(pixelsPerDegree(state, mapping) - without) < 1e-9);
      state.distortion.p1 = 0.01;
      state.intrinsics = {.fx = 400, .fy = 420, .cx = 100, .cy = 210};
      const double figure = pixelsPerDegree(state, mapping);
      QVERIFY(std::abs(figure / measured(state, mapping) - 1) < 1e-7);
    }
  }

  void whereNoLightFalls() {
    CameraState state = stateOf(60, {400, 400});
    state.distortion.k1 = -2;  // reaches 0.27 of the plane z = 1
    state.intrinsics = {.fx = 100, .fy = 100, .cx = -200, .cy = 200};
    QVERIFY(std::isnan(pixelsPerDegree(state)));
  }

  void distances() {
    PanelParams display;
    display.position = {1, 2, 3};
    CameraState state;
    state.camera.eye = {1, 2 - 0.3, 3.4};
    QCOMPARE(viewingOf(state, display, LensMapping::exact).distance, 0.5);
  }
};

QTEST_GUILESS_MAIN(TestViewing)
#include "test_viewing.moc"
