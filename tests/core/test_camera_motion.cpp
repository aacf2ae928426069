// SPDX-License-Identifier: BSD-3-Clause
// Tests the camera's motions against closed forms and by going there and back.
#include "core/optics/camera.h"

#include <QTest>
#include <array>
#include <cmath>

#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

constexpr std::array all{Motion::walk, Motion::strafe, Motion::rise,        Motion::turn,
                         Motion::tilt, Motion::roll,   Motion::orbitAcross, Motion::orbitUp};

/// On the axis, one metre before the panel.
CameraParams ahead() {
  CameraParams camera;
  camera.eye = {0, 0, 1};
  return camera;
}

/// Nothing is parallel, nothing is of length 1.
CameraParams askew() {
  CameraParams camera;
  camera.eye = {0.3, -0.2, 0.7};
  camera.lookat = {-0.1, 0.15, 0.05};
  camera.up = {0.4, 1.7, 0.2};
  return camera;
}

double apart(const Vec3& a, const Vec3& b) {
  return length(a - b);
}

double apart(const CameraParams& a, const CameraParams& b) {
  return std::max({apart(a.eye, b.eye), apart(a.lookat, b.lookat), apart(a.up, b.up)});
}

double distance(const CameraParams& camera) {
  return apart(camera.eye, camera.lookat);
}

Vec3 forward(const CameraParams& camera) {
  return Camera(camera).worldFromCamera().zAxis;
}

}  // namespace

class TestCameraMotion : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// From one metre before the panel, in numbers.
  void closedForms() {
    const auto is = [](Motion motion, double amount, Vec3 eye, Vec3 lookat, Vec3 up) {
      const CameraParams camera = moved(ahead(), motion, amount);
      return apart(camera.eye, eye) + apart(camera.lookat, lookat) + apart(camera.up, up) < 1e-14;
    };
    const double half = std::sqrt(0.5);
    const Vec3 eye{0, 0, 1};
    const Vec3 up{0, 1, 0};
    QVERIFY(is(Motion::walk, 0.25, {0, 0, 0.75}, {0, 0, -0.25}, up));
    QVERIFY(is(Motion::strafe, 0.25, {0.25, 0, 1}, {0.25, 0, 0}, up));
    QVERIFY(is(Motion::rise, 0.25, {0, 0.25, 1}, {0, 0.25, 0}, up));
    QVERIFY(is(Motion::turn, 90, eye, {1, 0, 1}, up));
    QVERIFY(is(Motion::turn, 45, eye, {half, 0, 1 - half}, up));
    QVERIFY(is(Motion::tilt, 45, eye, {0, half, 1 - half}, up));
    QVERIFY(is(Motion::roll, 90, eye, {}, {1, 0, 0}));
    QVERIFY(is(Motion::orbitAcross, 90, {1, 0, 0}, {}, up));
    QVERIFY(is(Motion::orbitUp, 45, {0, half, half}, {}, up));
  }

  void steps() {
    QCOMPARE(stepOf(Motion::walk), 0.01);
    QCOMPARE(stepOf(Motion::strafe), 0.01);
    QCOMPARE(stepOf(Motion::rise), 0.01);
    for (const Motion motion :
         {Motion::turn, Motion::tilt, Motion::roll, Motion::orbitAcross, Motion::orbitUp})
      QCOMPARE(stepOf(motion), 2.0);
  }

  void thereAndBack() {
    for (const Motion motion : all) {
      CameraParams camera = askew();
      for (int k = 0; k < 10; ++k) camera = moved(camera, motion, stepOf(motion));
      QVERIFY(apart(camera, askew()) > 0.05);
      for (int k = 0; k < 10; ++k) camera = moved(camera, motion, -stepOf(motion));
      QVERIFY2(apart(camera, askew()) < 1e-14, qPrintable(QString::number(int(motion))));
    }
  }

  void aFullTurnComesBack() {
    for (const Motion motion : {Motion::turn, Motion::roll, Motion::orbitAcross}) {
      CameraParams camera = askew();
      for (int k = 0; k < 36; ++k) camera = moved(camera, motion, 10);
      QVERIFY(apart(camera, askew()) < 1e-13);
    }
  }

  void whatEachKeeps() {
    const CameraParams from = askew();
    for (const Motion motion : all) {
      const CameraParams to = moved(from, motion, 7 * stepOf(motion));
      QVERIFY(std::abs(distance(to) - distance(from)) < 1e-15);
      QVERIFY(std::abs(length(to.up) - length(from.up)) < 1e-15);
      const bool isWay = stepOf(motion) == 0.01;
      if (isWay) QVERIFY(std::abs(apart(to.eye, from.eye) - 0.07) < 1e-15);
      QCOMPARE(apart(forward(to), forward(from)) < 1e-15, isWay || motion == Motion::roll);
      if (motion == Motion::orbitAcross || motion == Motion::orbitUp)
        QVERIFY(to.lookat == from.lookat);
      else if (!isWay)
        QVERIFY(to.eye == from.eye);
      if (motion != Motion::roll) QVERIFY(to.up == from.up);
    }
  }

  /// The angle to `up` is what turn, roll and the orbit across keep; tilt changes it by its amount.
  void angles() {
    const CameraParams from = askew();
    const auto fromUp = [](const CameraParams& camera) {
      return std::acos(dot(forward(camera), normalise(camera.up))) / radians(1);
    };
    for (const Motion motion : {Motion::turn, Motion::roll, Motion::orbitAcross})
      QVERIFY(std::abs(fromUp(moved(from, motion, 33)) - fromUp(from)) < 1e-12);
    QVERIFY(std::abs(fromUp(moved(from, Motion::tilt, 20)) - (fromUp(from) - 20)) < 1e-12);
    QVERIFY(std::abs(fromUp(moved(from, Motion::orbitUp, 20)) - (fromUp(from) + 20)) < 1e-12);
  }

  void neverEndsUpright() {
    for (const Motion motion : {Motion::tilt, Motion::orbitUp})
      for (const double sign : {1.0, -1.0}) {
        CameraParams camera = askew();
        for (int k = 0; k < 200; ++k) camera = moved(camera, motion, sign * stepOf(motion));
        const double sine = length(cross(forward(camera), normalise(camera.up)));
        QVERIFY(std::abs(sine - std::sin(radians(1))) < 1e-12);
        const CameraParams away = moved(camera, motion, -sign * 10);
        QVERIFY(apart(away, camera) > 0.05);
      }
  }

  /// A pose within the forbidden degree may turn away, and does not jump.
  void leavesAnUprightPose() {
    CameraParams camera = ahead();
    camera.eye = {0, 1, 1e-3};  // 0.057° from straight down
    QVERIFY(apart(moved(camera, Motion::orbitUp, 2), camera) < 1e-12);
    QVERIFY(apart(moved(camera, Motion::tilt, -2), camera) < 1e-12);
    const CameraParams away = moved(camera, Motion::orbitUp, -2);
    const double degrees = std::atan(1e-3) / radians(1) + 2;
    QVERIFY(apart(away.eye, length(camera.eye) * Vec3{0, std::cos(radians(degrees)),
                                                      std::sin(radians(degrees))}) < 1e-12);
    CameraParams below = ahead();
    below.eye = {0, -1, 1e-3};  // straight up
    QVERIFY(apart(moved(below, Motion::orbitUp, -2), below) < 1e-12);
    QVERIFY(apart(moved(below, Motion::tilt, 2), below) < 1e-12);
  }

  void otherFieldsStay() {
    CameraParams camera = askew();
    camera.name = "a";
    camera.fov = 33;
    camera.res = {7, 5};
    camera.weight = 2;
    for (const Motion motion : all) {
      CameraParams to = moved(camera, motion, 1);
      to.eye = camera.eye;
      to.lookat = camera.lookat;
      to.up = camera.up;
      QVERIFY(to == camera);
    }
  }

  /// An eye in front stays, one behind is mirrored, one in the plane is taken 1 cm away.
  void facingThePanel() {
    const RigidTransform panel = transformFromPose({0.5, -0.2, 3}, {10, 40, -20});
    for (const double z : {0.7, -0.7, 0.0}) {
      CameraParams camera = askew();
      camera.eye = panel.point({0.1, -0.3, z});
      camera.lookat = camera.eye + panel.zAxis;
      const CameraParams to = facing(camera, panel);
      QVERIFY(apart(to.eye, panel.point({0.1, -0.3, z == 0 ? 0.01 : 0.7})) < 1e-12);
      QVERIFY(apart(forward(to), normalise(panel.origin - to.eye)) < 1e-12);
      QVERIFY(to.up == camera.up);
    }
    CameraParams above;
    above.eye = panel.point({0, 0, 1});
    above.up = panel.zAxis;  // along the view
    QVERIFY(facing(above, panel).up == panel.yAxis);
    QVERIFY(hasFrame(facing(above, panel)));
  }

  void noFrameIsAnError() {
    CameraParams blind = ahead();
    blind.lookat = blind.eye;
    CameraParams upright = ahead();
    upright.up = {0, 0, 3};
    for (const Motion motion : all) {
      QVERIFY(errorOf([&] { (void)moved(blind, motion, 1); }).startsWith("lookat"));
      QVERIFY(errorOf([&] { (void)moved(upright, motion, 1); }).startsWith("up"));
    }
  }
};

QTEST_APPLESS_MAIN(TestCameraMotion)
#include "test_camera_motion.moc"
