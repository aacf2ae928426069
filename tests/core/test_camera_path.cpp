// SPDX-License-Identifier: BSD-3-Clause
// Tests paths of a camera against closed forms, and the up direction against quaternions.
#include "core/cameras/camera_path.h"
#include "core/cameras/focus_stack.h"

#include <QTest>
#include <cmath>

#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

double apart(const Vec3& a, const Vec3& b) {
  return length(a - b);
}

CameraState stateOf(const Vec3& eye, const Vec3& lookat, const Vec3& up = {0, 1, 0}) {
  CameraState state;
  state.camera.name = "some";
  state.camera.eye = eye;
  state.camera.lookat = lookat;
  state.camera.up = up;
  return state;
}

/// A quaternion; the product is Hamilton's.
struct Quaternion {
  double w = 1;
  Vec3 v;
  friend Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
  }
  [[nodiscard]] Vec3 turned(const Vec3& p) const {
    return (*this * Quaternion{0, p} * Quaternion{w, -1.0 * v}).v;
  }
};

/// Turns unit vector a by the share of the way to b: the power of the quaternion that turns a to b.
Vec3 onTheWay(const Vec3& a, const Vec3& b, double share) {
  const double half = share * std::acos(dot(a, b)) / 2;
  return Quaternion{std::cos(half), std::sin(half) * normalise(cross(a, b))}.turned(a);
}

/// Three states that differ in everything.
Session session() {
  Session session;
  session.display.position = {0.1, 0.2, -0.3};
  session.display.orientation = {20, 30, 40};
  session.cameras = {stateOf({0.1, 0, 0.6}, {0, 0.1, 0}),
                     stateOf({0.3, 0.1, 0.7}, {0.1, 0, 0}, normalise({0.3, 1, 0.2})),
                     stateOf({-0.3, 0.4, 0.9}, {0, 0, 0.1}, normalise({-1, 1, 1}))};
  for (std::size_t k = 0; k < 3; ++k) {
    CameraState& state = session.cameras[k];
    const auto number = double(k);
    state.camera.name = std::string(1, char('a' + k));
    state.camera.fov = 40 + 7 * number;
    state.camera.weight = 1 + number;
    state.distortion = {0.1 * number, -0.2, 0.01 * number, 0.02, 0.3 * number};
    state.psf.sigma = 0.5 + number;
    state.psf.windowSize = 1 + 4 * int(k);
  }
  return session;
}

}  // namespace

class TestCameraPath : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void passesThroughItsStates() {
    const Session given = session();
    for (const int count : {1, 2, 6, 29}) {
      const std::vector<CameraState> path = statesAlong({PathKind::between, count}, given, 0);
      QCOMPARE(path.size(), std::size_t(2 * count + 3));
      for (std::size_t k = 0; k < 3; ++k) {
        CameraState state = path[k * std::size_t(count + 1)];
        state.camera.name = given.cameras[k].camera.name;
        QVERIFY(state == given.cameras[k]);
      }
    }
    QVERIFY(stateAt(given.cameras, -1) == given.cameras[0]);
    QVERIFY(stateAt(given.cameras, 2) == given.cameras[2]);
    QVERIFY(stateAt(given.cameras, 7.5) == given.cameras[2]);
  }

  void halfwayIsTheMean() {
    const Session given = session();
    const CameraState half = stateAt(given.cameras, 0.5);
    QVERIFY(apart(half.camera.eye, {0.2, 0.05, 0.65}) < 1e-15);
    QVERIFY(apart(half.camera.lookat, {0.05, 0.05, 0}) < 1e-15);
    QCOMPARE(half.camera.fov, 43.5);
    QCOMPARE(half.camera.weight, 1.5);
    QCOMPARE(half.psf.sigma, 1.0);
    QCOMPARE(half.psf.windowSize, 3);
    QVERIFY((half.distortion == DistortionParams{0.05, -0.2, 0.005, 0.02, 0.15}));
    QVERIFY(!half.intrinsics.isGiven());
  }

  /// The nearest odd widths to 5, 6, 7, 8, 9, the wider where two are.
  void windowsAreOdd() {
    const std::vector<CameraState> states = session().cameras;
    const std::array<int, 5> expected{5, 7, 7, 9, 9};
    for (std::size_t k = 0; k < 5; ++k)
      QCOMPARE(stateAt(states, 1 + double(k) / 4).psf.windowSize, expected[k]);
  }

  void upTakesTheGreatCircle() {
    const std::vector<CameraState> states = session().cameras;
    for (const double position : {0.1, 0.37, 0.9, 1.2, 1.75}) {
      const auto from = std::size_t(position);
      const Vec3 expected =
          onTheWay(states[from].camera.up, states[from + 1].camera.up, position - double(from));
      QVERIFY(apart(stateAt(states, position).camera.up, expected) < 1e-14);
    }
  }

  /// Where the view is the same this is a roll; half a turn has no great circle of its own.
  void rolls() {
    const Vec3 eye{0, 0, 1};
    for (const double roll : {50.0, 180.0}) {
      const double end = radians(roll);
      const std::vector<CameraState> states{stateOf(eye, {}),
                                            stateOf(eye, {}, {std::sin(end), std::cos(end), 0})};
      const Vec3 up = stateAt(states, 0.3).camera.up;
      QVERIFY(std::abs(std::hypot(up.x, up.y) - 1) < 1e-14);
      QVERIFY(std::abs(std::acos(up.y) - 0.3 * end) < 1e-12);
    }
  }

  void levelCamerasStayLevel() {
    const std::vector<CameraState> states{stateOf({0.4, 0.3, 0.5}, {}),
                                          stateOf({-0.5, 0, 0.2}, {})};
    for (const double position : {0.2, 0.5, 0.8}) {
      const CameraState state = stateAt(states, position);
      QVERIFY(state.camera.up == Vec3(0, 1, 0));
      QVERIFY(std::abs(Camera(state.camera).worldFromCamera().xAxis.y) < 1e-15);
    }
  }

  /// A calibrated camera and a field of view meet in pixels.
  void focalLengthsAreLinear() {
    std::vector<CameraState> states = session().cameras;
    states[1].intrinsics = {900, 800, 310, 290};
    const Camera first(states[0].camera);
    const IntrinsicsParams half = stateAt(states, 0.5).intrinsics;
    QVERIFY(std::abs(half.fx - (first.focalLength().x + 900) / 2) < 1e-9);
    QVERIFY(std::abs(half.fy - (first.focalLength().y + 800) / 2) < 1e-9);
    QVERIFY(std::abs(half.cx - (first.centre().x + 310) / 2) < 1e-9);
    QVERIFY(std::abs(half.cy - (first.centre().y + 290) / 2) < 1e-9);
    states[0].intrinsics = states[1].intrinsics;
    QVERIFY(stateAt(states, 0.3).intrinsics == states[0].intrinsics);
  }

  void orbitsKeepTheirDistance() {
    const Session given = session();
    const CameraParams& own = given.cameras[1].camera;
    const std::vector<CameraState> path = statesAlong({PathKind::orbit, 9, 90}, given, 1);
    QCOMPARE(path.size(), std::size_t(9));
    for (std::size_t k = 0; k < 9; ++k) {
      const CameraParams& camera = path[k].camera;
      QVERIFY(camera.lookat == own.lookat);
      QVERIFY(std::abs(apart(camera.eye, own.lookat) - apart(own.eye, own.lookat)) < 1e-14);
      // The angle between the directions without their part along `up`.
      const auto flat = [&](const Vec3& eye) {
        const Vec3 view = eye - own.lookat;
        return normalise(view - dot(view, normalise(own.up)) * normalise(own.up));
      };
      const double angle = std::acos(std::min(1.0, dot(flat(camera.eye), flat(own.eye))));
      QVERIFY(std::abs(angle - radians(10) * std::abs(double(k) - 4)) < 1e-7);
    }
    QVERIFY(apart(path[4].camera.eye, own.eye) < 1e-15);
    const Vec3 right = Camera(own).worldFromCamera().xAxis;
    QVERIFY(dot(path[5].camera.eye - own.eye, right) > 0);
  }

  /// In the display frame the camera turns about y: the height stays, atan2(x, z) grows.
  void turntablesTurnAboutTheDisplay() {
    const Session given = session();
    const RigidTransform display =
        transformFromPose(given.display.position, given.display.orientation).inverse();
    const Vec3 start = display.point(given.cameras[0].camera.eye);
    const auto path = statesAlong({PathKind::turntable, 8, 360}, given, 0);
    for (std::size_t k = 0; k < 8; ++k) {
      const Vec3 eye = display.point(path[k].camera.eye);
      QVERIFY(std::abs(eye.y - start.y) < 1e-14);
      const double angle = radians(-180 + 22.5 + 45 * double(k)) + std::atan2(start.x, start.z);
      const double radius = std::hypot(start.x, start.z);
      QVERIFY(apart(eye, {radius * std::sin(angle), start.y, radius * std::cos(angle)}) < 1e-14);
      const auto view = [&](const CameraParams& camera) {
        return dot(camera.lookat - camera.eye, camera.up);
      };
      QVERIFY(std::abs(view(path[k].camera) - view(given.cameras[0].camera)) < 1e-14);
    }
  }

  /// In even steps of dioptres between the ends of what is sharp.
  void aFocusStackIsAPath() {
    Session given = session();
    given.display.hogels = {100, 100};
    given.display.directions = {30, 30};
    QVERIFY(errorOf([&] {
              statesAlong({PathKind::focus, 3}, given, 0);
            }).contains("a pinhole, which sees everything sharp"));
    given.cameras[0].pupil.diameter = 0.004;
    const auto path = statesAlong({PathKind::focus, 3}, given, 0);
    const std::vector<double> wanted = focusDistances(given.cameras[0], displayOf(given), 3);
    QCOMPARE(path.size(), std::size_t(3));
    for (std::size_t k = 0; k < 3; ++k) {
      QCOMPARE(path[k].pupil.focus, wanted[k]);
      QVERIFY(path[k].camera.eye == given.cameras[0].camera.eye);
    }
    QVERIFY(path[0].pupil.focus < path[2].pupil.focus);
    const double middle = (1 / path[0].pupil.focus + 1 / path[2].pupil.focus) / 2;
    QVERIFY(std::abs(1 / path[1].pupil.focus - middle) < 1e-12);
    QCOMPARE(path[2].camera.name, std::string("frame_0003"));
  }

  void namesSortAsTheyAreNumbered() {
    Session given = session();
    QCOMPARE(statesAlong({}, given, 0)[2].camera.name, std::string("frame_0003"));
    const auto path = statesAlong({PathKind::between, 6000}, given, 0);
    QCOMPARE(path.front().camera.name, std::string("frame_00001"));
    QCOMPARE(path.back().camera.name, std::string("frame_12003"));
    QVERIFY(std::ranges::is_sorted(path, {},
                                   [](const CameraState& state) { return state.camera.name; }));
  }

  void sizesMustBeEqual() {
    Session given = session();
    given.cameras[1].camera.res = {300, 200};
    QVERIFY(errorOf([&] {
              statesAlong({PathKind::between, 2}, given, 0);
            }).startsWith("b: camera.res: differs from that of a"));
    QCOMPARE(statesAlong({}, given, 0).size(), std::size_t(3));
    QVERIFY(errorOf([] { statesAlong({}, {}, 0); }).contains("there is no state"));
  }

  void pathsEnd() {
    Session given = session();
    given.cameras.resize(1001, given.cameras[0]);
    QCOMPARE(statesAlong({PathKind::between, 9}, given, 0).size(), std::size_t(10001));
    QVERIFY(errorOf([&] { statesAlong({PathKind::between, 999}, given, 0); }).contains("million"));
    for (const int count : {1'000'001, -1})
      QVERIFY(errorOf([&] {
                statesAlong({PathKind::orbit, count}, given, 0);
              }).contains("million"));
    QVERIFY(errorOf([] {
              statesAlong({PathKind::orbit, 3}, {}, 0);
            }).contains("there is no state"));
  }
};

QTEST_APPLESS_MAIN(TestCameraPath)
#include "test_camera_path.moc"
