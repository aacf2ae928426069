// SPDX-License-Identifier: BSD-3-Clause
// The two eyes of a state, against the closed form of their disparity.
#include "core/optics/eyes.h"

#include <QTest>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "tests/core/live_content.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

constexpr double ipd = 0.063;
constexpr double distance = 0.6;

CameraState headInFront() {
  CameraState head;
  head.camera.name = "head";
  head.camera.eye = {0, 0, distance};
  head.camera.res = {800, 3};
  head.intrinsics.fx = 2000;
  head.stereo.ipd = ipd;
  return head;
}

DisplayParams display() {
  DisplayParams display;
  display.size = {0.4, 0.4};
  display.hogels = {10, 10};
  display.directions = {10, 10};
  display.fov = {120, 120};
  return display;
}

/// The phase of a grating in the middle row of an image, in periods, by its Fourier coefficient.
double phaseOf(const FloatImage& image, double periodPixels) {
  double cosine = 0;
  double sine = 0;
  for (int x = 0; x < image.width; ++x) {
    const double value = double(image.rgb[3 * std::size_t(image.width + x)]);
    const double angle = 2 * std::numbers::pi * x / periodPixels;
    cosine += value * std::cos(angle);
    sine += value * std::sin(angle);
  }
  return std::atan2(sine, cosine) / (2 * std::numbers::pi);
}

}  // namespace

class TestEyes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eyesStandBesideTheHead();
  void eyesAreExpandedOnce();
  void panelsCentreHasNoDisparity();
  void disparityIsTheClosedForm_data();
  void disparityIsTheClosedForm();
  void namesOfEyesAreNotTaken();
};

void TestEyes::eyesStandBesideTheHead() {
  CameraState head = headInFront();
  head.camera.weight = 3;
  head.camera.up = {1, 0, 0};  // the right is then -y
  const CameraState left = eyeOf(head, display(), Eye::left);
  const CameraState right = eyeOf(head, display(), Eye::right);
  QCOMPARE(left.camera.name, std::string("head/left"));
  QCOMPARE(right.camera.name, std::string("head/right"));
  QCOMPARE(fileNameOf(right.camera.name), std::string("head.right"));
  QCOMPARE(headOf(right.camera.name), head.camera.name);
  QVERIFY(length(left.camera.eye - Vec3{0, ipd / 2, distance}) < 1e-12);
  QVERIFY(length(right.camera.eye - Vec3{0, -ipd / 2, distance}) < 1e-12);
  QVERIFY(length(right.camera.lookat - Vec3{0, -ipd / 2, 0}) < 1e-12);
  QCOMPARE(left.camera.weight, 1.5);
  QCOMPARE(left.stereo.ipd, 0.0);
  QVERIFY(std::abs(left.intrinsics.cx - (399.5 - 2000 * ipd / (2 * distance))) < 1e-9);
  QVERIFY(std::abs(right.intrinsics.cx - (399.5 + 2000 * ipd / (2 * distance))) < 1e-9);
}

void TestEyes::eyesAreExpandedOnce() {
  Session session;
  session.display = display();
  session.cameras = {headInFront(), headInFront()};
  session.cameras[0].stereo = {};
  session.cameras[0].camera.name = "one eye";
  const Session eyes = withEyes(session);
  QCOMPARE(int(eyes.cameras.size()), 3);
  QCOMPARE(eyes.cameras[0], session.cameras[0]);
  QCOMPARE(eyes.cameras[1], eyeOf(session.cameras[1], session.display, Eye::left));
  QCOMPARE(withEyes(eyes), eyes);
}

void TestEyes::panelsCentreHasNoDisparity() {
  DisplayParams turned = display();
  turned.position = {0.05, -0.02, -0.1};
  turned.orientation = {10, 25, 0};
  const CameraState head = headInFront();
  for (const Eye eye : {Eye::left, Eye::right}) {
    const CameraState state = eyeOf(head, turned, eye);
    const auto pixelOf = [&](const CameraState& of) {
      const Camera camera(of.camera, of.intrinsics);
      const Vec3 p = camera.worldFromCamera().inverse().point(turned.position);
      return camera.centre().x + camera.focalLength().x * p.x / p.z;
    };
    QVERIFY(std::abs(pixelOf(state) - pixelOf(head)) < 1e-9);
  }
}

void TestEyes::disparityIsTheClosedForm_data() {
  QTest::addColumn<double>("z");
  QTest::newRow("on the panel") << 0.0;
  QTest::newRow("in front") << 0.1;
  QTest::newRow("behind") << -0.3;
}

/// A point at depth z is f ipd (1/D − 1/(D − z)) further right in the right eye's image than in the
/// left one's. The grating's period is wider than that.
void TestEyes::disparityIsTheClosedForm() {
  QFETCH(const double, z);
  const double expected = 2000 * ipd * (1 / distance - 1 / (distance - z));
  constexpr double periodPixels = 200;
  const double period = periodPixels / 2000 * (distance - z);
  const auto grating = std::make_shared<LivePlanes>(
      std::vector<LivePlane>{{z, [period](double x, double) {
                                return 127 + 100 * std::cos(2 * std::numbers::pi * x / period);
                              }}});
  RenderJob job;
  static_cast<DisplayParams&>(job.display) = display();
  job.lightField = liveSource(grating, job.display);
  job.isIdeal = true;
  const auto phase = [&](Eye eye) {
    job.state = eyeOf(headInFront(), job.display, eye);
    return phaseOf(Renderer(serialRows).renderFloat(job), periodPixels);
  };
  const double disparity = std::remainder(phase(Eye::right) - phase(Eye::left), 1.0) * periodPixels;
  QVERIFY2(std::abs(disparity - expected) < 0.05,
           qPrintable(QString("%1, not %2").arg(disparity).arg(expected)));
}

void TestEyes::namesOfEyesAreNotTaken() {
  Session session;
  session.display = display();
  session.lightField.file = "x.png";
  session.cameras = {headInFront(), headInFront()};
  session.cameras[1].stereo = {};
  session.cameras[1].camera.name = "Head.LEFT";
  QVERIFY_EXCEPTION_THROWN(check(session), InputError);
  session.cameras[0].stereo = {};
  check(session);
}

QTEST_APPLESS_MAIN(TestEyes)
#include "test_eyes.moc"
