// SPDX-License-Identifier: BSD-3-Clause
// Tests the camera's frame, its focal length and centre, and the poses that give no frame.
#include <QTest>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/optics/camera.h"
#include "tests/core/random.h"

using namespace hogelscope;

Q_DECLARE_METATYPE(hogelscope::Vec3)

namespace {

double distance(const Vec3& a, const Vec3& b) {
  return length(a - b);
}

CameraParams camera(const Vec3& eye, const Vec3& lookat, const Vec3& up) {
  CameraParams params;
  params.eye = eye;
  params.lookat = lookat;
  params.up = up;
  return params;
}

}  // namespace

class TestCamera : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void frame_data();
  void frame();
  void frameIsOrthonormal();
  void focalLengthAndCentre_data();
  void focalLengthAndCentre();
  void intrinsicsTakeThePlaceOfFov();
  void cornerEdgeIsHalfTheFov_data();
  void cornerEdgeIsHalfTheFov();
  void normalisedIsThePinholes();
  void noFrame_data();
  void noFrame();
};

void TestCamera::frame_data() {
  QTest::addColumn<Vec3>("eye");
  QTest::addColumn<Vec3>("lookat");
  QTest::addColumn<Vec3>("up");
  QTest::addColumn<Vec3>("right");
  QTest::addColumn<Vec3>("down");
  QTest::addColumn<Vec3>("forward");
  const auto row = [](const char* name, Vec3 eye, Vec3 lookat, Vec3 up, Vec3 right, Vec3 down,
                      Vec3 forward) {
    QTest::newRow(name) << eye << lookat << up << right << down << forward;
  };
  const double s = std::sqrt(0.5);
  row("in front", {0, 0, 1}, {}, {0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1});
  row("behind", {0, 0, -2}, {}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1});
  row("from the right", {1, 0, 0}, {}, {0, 1, 0}, {0, 0, -1}, {0, -1, 0}, {-1, 0, 0});
  row("from above", {0, 2, 0}, {}, {0, 0, -1}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0});
  row("rolled", {0, 0, 1}, {}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}, {0, 0, -1});
  row("upside down", {0, 0, 1}, {}, {0, -1, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1});
  row("up is tilted", {0, 0, 1}, {}, {0, 5, 5}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1});
  row("up is nearly parallel", {0, 2, 0}, {}, {0, 1, -1e-8}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0});
  row("diagonal", {1, 0, 1}, {}, {0, 1, 0}, {s, 0, -s}, {0, -1, 0}, {-s, 0, -s});
  row("away from the origin", {3, 4, 5}, {3, 4, 2}, {0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1});
  row("tiny", {0, 0, 1e-200}, {}, {0, 1e-200, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1});
  row("huge", {0, 0, 1e200}, {}, {0, 1e200, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1});
}

void TestCamera::frame() {
  QFETCH(const Vec3, eye);
  QFETCH(const Vec3, lookat);
  QFETCH(const Vec3, up);
  QFETCH(const Vec3, right);
  QFETCH(const Vec3, down);
  QFETCH(const Vec3, forward);
  const RigidTransform world = Camera(camera(eye, lookat, up)).worldFromCamera();
  QVERIFY(distance(world.xAxis, right) < 1e-15);
  QVERIFY(distance(world.yAxis, down) < 1e-15);
  QVERIFY(distance(world.zAxis, forward) < 1e-15);
  QVERIFY(world.origin == eye);
}

void TestCamera::frameIsOrthonormal() {
  Random random(1);
  const auto vector = [&random] {
    return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  };
  for (int repeat = 0; repeat < 1000; ++repeat) {
    const CameraParams params = camera(vector(), vector(), vector());
    const RigidTransform world = Camera(params).worldFromCamera();
    QVERIFY(std::abs(length(world.xAxis) - 1) < 1e-14);
    QVERIFY(std::abs(length(world.yAxis) - 1) < 1e-14);
    QVERIFY(distance(cross(world.xAxis, world.yAxis), world.zAxis) < 1e-14);
    // Up leans neither left nor right, and not down.
    QVERIFY(std::abs(dot(world.xAxis, params.up)) < 1e-14);
    QVERIFY(dot(world.yAxis, params.up) < 0);
    const Vec3 toLookat = params.lookat - params.eye;
    QVERIFY(distance(length(toLookat) * world.zAxis, toLookat) < 1e-14);
  }
}

void TestCamera::focalLengthAndCentre_data() {
  QTest::addColumn<int>("width");
  QTest::addColumn<int>("height");
  QTest::addColumn<double>("fov");
  QTest::addColumn<double>("focal");
  QTest::newRow("the paper's") << 600 << 600 << 60.0 << 300 * std::sqrt(3.0);
  QTest::newRow("wide picture") << 640 << 480 << 90.0 << 240.0;
  QTest::newRow("tall picture") << 480 << 640 << 90.0 << 320.0;
  QTest::newRow("one pixel") << 1 << 1 << 90.0 << 0.5;
  QTest::newRow("odd") << 7 << 5 << 120.0 << 2.5 / std::sqrt(3.0);
}

void TestCamera::focalLengthAndCentre() {
  QFETCH(const int, width);
  QFETCH(const int, height);
  QFETCH(const double, fov);
  QFETCH(const double, focal);
  CameraParams params;
  params.res = {width, height};
  params.fov = fov;
  const Camera taken(params);
  QVERIFY(std::abs(taken.focalLength().x / focal - 1) < 1e-14);
  QCOMPARE(taken.focalLength().y, taken.focalLength().x);
  QCOMPARE(taken.centre().x, (width - 1) / 2.0);
  QCOMPARE(taken.centre().y, (height - 1) / 2.0);
}

/// K of OpenCV's samples/data/left_intrinsics.yml but for fy; the point under a pixel as K⁻¹ gives
/// it.
void TestCamera::intrinsicsTakeThePlaceOfFov() {
  CameraParams params;
  params.res = {640, 480};
  const Camera all(params, {535.9, 534.25, 342.28, 235.57});
  const Vec2 corner = all.normalised(342.28 + 535.9, 235.57 - 2 * 534.25);
  QVERIFY(std::abs(corner.x - 1) < 1e-14 && std::abs(corner.y + 2) < 1e-14);
  const Camera some(params, {500});
  QVERIFY((some.normalised(319.5 + 250, 239.5 + 500) == Vec2{0.5, 1}));
  params.fov = 90;
  const double halfHeight = Camera(params).normalised(0, 479.5).y;
  QVERIFY(std::abs(halfHeight - Camera(params, {240}).normalised(0, 479.5).y) < 1e-14);
}

void TestCamera::cornerEdgeIsHalfTheFov_data() {
  QTest::addColumn<double>("fov");
  for (const double fov : {0.01, 1.0, 60.0, 90.0, 150.0, 179.9}) QTest::addRow("%g", fov) << fov;
}

void TestCamera::cornerEdgeIsHalfTheFov() {
  QFETCH(const double, fov);
  CameraParams params;
  params.res = {31, 20};
  params.fov = fov;
  const Camera taken(params);
  const auto degrees = [](double slope) { return std::atan(slope) * 180 / std::acos(-1.0); };
  QVERIFY(std::abs(degrees(taken.normalised(0, -0.5).y) + fov / 2) < 1e-12);
  QVERIFY(std::abs(degrees(taken.normalised(0, 19.5).y) - fov / 2) < 1e-12);
  // Square pixels: 31 of them across stand as 31/20 of the height.
  const double half = taken.normalised(0, 19.5).y;
  QVERIFY(std::abs(taken.normalised(-0.5, 0).x / half + 1.55) < 1e-12);
  QVERIFY(std::abs(taken.normalised(30.5, 0).x / half - 1.55) < 1e-12);
}

void TestCamera::normalisedIsThePinholes() {
  CameraParams params;
  params.res = {640, 480};
  params.fov = 90;
  const Camera taken(params);
  QVERIFY(taken.normalised(319.5, 239.5) == (Vec2{0, 0}));
  const Vec2 p = taken.normalised(319.5 + 24, 239.5 - 60);
  QVERIFY(std::abs(p.x - 0.1) < 1e-15 && std::abs(p.y + 0.25) < 1e-15);
}

void TestCamera::noFrame_data() {
  QTest::addColumn<Vec3>("eye");
  QTest::addColumn<Vec3>("lookat");
  QTest::addColumn<Vec3>("up");
  QTest::addColumn<QString>("message");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const QString atEye = "lookat: is the eye itself: the camera looks nowhere";
  const QString parallel = "up: is parallel to the line from eye to lookat";
  const auto row = [](const char* name, Vec3 eye, Vec3 lookat, Vec3 up, const QString& message) {
    QTest::newRow(name) << eye << lookat << up << message;
  };
  row("lookat is the eye", {1, 2, 3}, {1, 2, 3}, {0, 1, 0}, atEye);
  row("eye is not a number", {nan, 2, 3}, {1, 2, 3}, {0, 1, 0}, atEye);
  row("up is zero", {0, 0, 1}, {}, {}, "up: is zero: give the direction that is up in the picture");
  row("up is parallel", {0, 5, 0}, {}, {0, 1, 0}, parallel);
  row("up is forward", {0, 5, 0}, {}, {0, -3, 0}, parallel);
  row("up is parallel, but for rounding", {0, 5, 0}, {}, {1e-10, 1, 0}, parallel);
}

void TestCamera::noFrame() {
  QFETCH(const Vec3, eye);
  QFETCH(const Vec3, lookat);
  QFETCH(const Vec3, up);
  QFETCH(const QString, message);
  try {
    const Camera none(camera(eye, lookat, up));
    QFAIL("a frame was found");
  } catch (const InputError& error) {
    QCOMPARE(QString(error.what()), message);
  }
}

QTEST_APPLESS_MAIN(TestCamera)
#include "test_camera.moc"
