// SPDX-License-Identifier: BSD-3-Clause
// Tests what states are made of camera sets: mixtures, paths, traces, templates, names, and that a
// seed means the same on every machine.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "tests/core/camera_sets.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

Session sampleSession() {
  Session session;
  session.display.position = {1, 2, 3};
  session.display.orientation = {10, 40, 20};
  session.lightField.file = "a.png";
  session.display.hogels = session.display.directions = {4, 4};
  CameraState state;
  state.camera.name = "first";
  session.cameras.push_back(state);
  state.camera.name = "second";
  state.camera.fov = 41;
  state.camera.res = {30, 20};
  state.camera.weight = 7;
  state.intrinsics.fx = 25;
  state.distortion.k1 = 0.25;
  state.psf = {1.5, 5};
  session.cameras.push_back(state);
  return session;
}

}  // namespace

class TestCameraSet : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sameOnEveryMachine();
  void moreStatesBeginAlike();
  void mixtureShares();
  void pathStepsAreEqual();
  void traceWeighsByTime();
  void traceThatHolds();
  void statesAreTheTemplates();
  void statesStandInFrontOfATurnedPanel();
  void namesSortAndAreUnique();
  void numbersGoOnInAnyCase();
  void badSets();
};

/// The positions were also worked out by another program, from the definition of mt19937_64.
void TestCameraSet::sameOnEveryMachine() {
  RandomNumbers random(1);
  QCOMPARE(random.unit(), double(2469588189546311528ULL >> 11) / 9007199254740992.0);
  const auto firstOf = [](CameraSpread spread) {
    Session session = sampleSession();
    session.display.position = session.display.orientation = {};
    return withCameras(session, boxSet(spread, 2)).cameras;
  };
  const auto uniform = firstOf(CameraSpread::random);
  QCOMPARE(uniform[2].camera.eye, (Vec3{-0.119674014, -0.272718593, 0.680485962}));
  QCOMPARE(uniform[3].camera.eye, (Vec3{-0.187385463, -0.229820377, 0.864543219}));
  const auto normal = firstOf(CameraSpread::normal);
  QCOMPARE(normal[2].camera.eye, (Vec3{0.152648875, -0.145702754, 0.778918878}));
  QCOMPARE(normal[3].camera.eye, (Vec3{0.25104745, -0.2428792, 0.659377107}));
}

void TestCameraSet::moreStatesBeginAlike() {
  for (const CameraSpread spread : {CameraSpread::random, CameraSpread::normal}) {
    CameraSet set = boxSet(spread, 5);
    set.region.lookat = LookAt::jittered;
    const std::vector<CameraPose> few = posesOf(set, panel);
    set.params.count = 50;
    const std::vector<CameraPose> many = posesOf(set, panel);
    for (std::size_t k = 0; k < 5; ++k)
      QVERIFY(few[k].eye == many[k].eye && few[k].lookat == many[k].lookat);
    set.params.seed = 2;
    QVERIFY(!(posesOf(set, panel)[0].eye == many[0].eye));
  }
}

void TestCameraSet::mixtureShares() {
  CameraSet set = boxSet(CameraSpread::uniform, 10);
  CameraRegionParams left = set.region;
  left.centre.x = -5;
  CameraRegionParams right = set.region;
  right.distribution = CameraSpread::random;
  right.centre.x = 5;
  set.source = Mixture{{{1, left}, {2, right}, {0, set.region}}};
  std::vector<CameraPose> poses = posesOf(set, panel);
  QCOMPARE(poses.size(), std::size_t(10));
  for (std::size_t k = 0; k < 10; ++k) QCOMPARE(poses[k].eye.x > 0, k >= 3);  // 3⅓, 6⅔
  set.params.count = 1;
  poses = posesOf(set, panel);
  QVERIFY(poses.size() == 1 && poses[0].eye.x > 0);
}

void TestCameraSet::pathStepsAreEqual() {
  CameraSet set;
  set.params.count = 8;
  set.region.lookat = LookAt::nearest;
  // 3 + 0 + 4 metres, a stop in between.
  set.source = PosePath{{{{0, 0, 1}}, {{3, 0, 1}}, {{3, 0, 1}}, {{3, 4, 1}, {notGiven}, 5}}};
  const std::vector<CameraPose> poses = posesOf(set, panel);
  QCOMPARE(poses.size(), std::size_t(8));
  for (int k = 0; k < 8; ++k) {
    const CameraPose& pose = poses[std::size_t(k)];
    QVERIFY(near(pose.eye, {std::min(k, 3) * 1.0, std::max(k - 3, 0) * 1.0, 1}, 1e-14));
    QVERIFY(near(pose.lookat, {std::min(pose.eye.x, 0.25), std::min(pose.eye.y, 0.15), 0}, 0));
    QVERIFY(std::abs(pose.weight - (1 + std::max(k - 3, 0))) < 1e-14);
  }
  set.params.count = 3;
  set.source = PosePath{{{{0, 0, 1}, {1, 0, 0}}, {{0, 2, 1}, {3, 0, 0}}}};
  const std::vector<CameraPose> turning = posesOf(set, panel);
  QVERIFY(near(turning[1].eye, {0, 1, 1}, 1e-15) && near(turning[1].lookat, {2, 0, 0}, 1e-15));
}

/// Half of the time at one place, then a walk, then a quarter at another.
void TestCameraSet::traceWeighsByTime() {
  CameraSet set;
  set.params.count = 400;
  set.params.place = 0.008;  // the walk's samples are 0.01 m apart
  set.source = Trace{{{0, {0, 0, 1}}, {4, {0, 0, 1}}, {6, {1, 0, 1}}, {8, {1, 0, 1}}}};
  const std::vector<CameraPose> poses = posesOf(set, panel);
  double sum = 0;
  double mean = 0;
  for (const CameraPose& pose : poses) {
    sum += pose.weight;
    mean += pose.weight * pose.eye.x;
  }
  QCOMPARE(sum, 400.0);
  QVERIFY(std::abs(mean / 400 - (0.125 + 0.25)) < 1e-12);  // the trace's own mean over time
  QCOMPARE(poses.size(), std::size_t(102));
  QCOMPARE(poses.front().weight, 200.0);
  QCOMPARE(poses.back().weight, 100.0);
  QVERIFY(near(poses.front().eye, {0, 0, 1}, 1e-14));
  set.params.place = 4;
  QCOMPARE(posesOf(set, panel).size(), std::size_t(1));
}

/// Two recordings meet at 3: what is between them takes no time, and a last line neither.
void TestCameraSet::traceThatHolds() {
  CameraSet set;
  set.params.count = 400;
  set.source = Trace{{{0, {0, 0, 1}}, {3, {1, 0, 1}}, {3, {2, 0, 1}}, {4, {3, 0, 1}}}, true};
  const std::vector<CameraPose> poses = posesOf(set, panel);
  QCOMPARE(poses.size(), std::size_t(2));
  QCOMPARE(poses[0].weight, 300.0);
  QCOMPARE(poses[0].eye, (Vec3{0, 0, 1}));
  QCOMPARE(poses[1].weight, 100.0);
  QCOMPARE(poses[1].eye, (Vec3{2, 0, 1}));
}

void TestCameraSet::statesAreTheTemplates() {
  const Session session = sampleSession();
  CameraSet set = boxSet(CameraSpread::random, 3);
  set.params.templateState = "second";
  const Session made = withCameras(session, set);
  QCOMPARE(made.cameras.size(), std::size_t(5));
  for (std::size_t k = 2; k < 5; ++k) {
    CameraState state = made.cameras[k];
    QCOMPARE(state.camera.weight, 1.0);
    state.camera.name = session.cameras[1].camera.name;
    state.camera.eye = session.cameras[1].camera.eye;
    state.camera.lookat = session.cameras[1].camera.lookat;
    state.camera.up = session.cameras[1].camera.up;
    state.camera.weight = session.cameras[1].camera.weight;
    QVERIFY(state == session.cameras[1]);
  }
  Session rest = made;
  rest.cameras.resize(2);
  QVERIFY(rest == session);
  set.params.templateState = "";
  QCOMPARE(withCameras(session, set).cameras[2].camera.fov, 60.0);
}

void TestCameraSet::statesStandInFrontOfATurnedPanel() {
  const Session session = sampleSession();
  const CameraSet set = arcSet(CameraSpread::random, 20);
  const Session made = withCameras(session, set);
  const std::vector<CameraPose> poses = posesOf(set, session.display.size);
  const Display display(displayOf(session));
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const CameraParams& camera = made.cameras[2 + k].camera;
    QVERIFY(near(display.displayFromWorld().point(camera.eye), poses[k].eye, 2e-9));
    QVERIFY(near(display.displayFromWorld().direction(camera.up), {0, 1, 0}, 2e-9));
    const Vec3 eye = display.displayFromWorld().point(camera.eye);
    const Vec3 forward = display.displayFromWorld().direction(camera.lookat - camera.eye);
    QVERIFY(near(eye + forward, {0, 0, 0}, 5e-9));
  }
}

void TestCameraSet::namesSortAndAreUnique() {
  CameraSet set = boxSet(CameraSpread::uniform, 9);
  Session session = sampleSession();
  session.cameras[1].camera.name = "uniform-x7";
  session = withCameras(session, set);
  session = withCameras(session, set);  // goes on where the first one ended
  set.params.count = 120;
  set.params.name = "ring";
  session = withCameras(session, set);
  check(session);  // no name twice
  QCOMPARE(session.cameras[2].camera.name, std::string("uniform-0001"));
  QCOMPARE(session.cameras[11].camera.name, std::string("uniform-0010"));
  QCOMPARE(session.cameras.back().camera.name, std::string("ring-0120"));
  std::vector<std::string> names;
  for (std::size_t k = 2; k < 20; ++k) names.push_back(session.cameras[k].camera.name);
  QVERIFY(std::is_sorted(names.begin(), names.end()));
  set.params.count = 12000;
  names.clear();
  for (const CameraState& state : withCameras(sampleSession(), set).cameras)
    names.push_back(state.camera.name);
  QCOMPARE(names[2], std::string("ring-00001"));
  QVERIFY(std::is_sorted(names.begin() + 2, names.end()));
}

/// A set whose name differs from an earlier one's in case only goes on with its numbers.
void TestCameraSet::numbersGoOnInAnyCase() {
  CameraSet set = boxSet(CameraSpread::uniform, 3);
  set.params.name = "ring";
  Session session = withCameras(sampleSession(), set);
  set.params.name = "Ring";
  session = withCameras(session, set);
  check(session);
  QCOMPARE(session.cameras.back().camera.name, std::string("Ring-0006"));
}

void TestCameraSet::badSets() {
  const Session session = sampleSession();
  CameraSet set = boxSet(CameraSpread::uniform, 2);
  const auto refusal = [&] { return errorOf([&] { (void)withCameras(session, set); }); };
  set.params.templateState = "third";
  QCOMPARE(refusal(), QString("cameraSet.template: \"third\" is no state of the session"));
  set.params.templateState = "";
  set.params.name = "a/b";
  QCOMPARE(refusal(), QString("cameraSet.name: \"a/b-0001\" has a slash; it names the picture's "
                              "file"));
  set.params.name = "";
  set.source = PoseList{{{{0, 0, 1}}, {{0, 0, 1}, {0, 0, 1}}}};
  QCOMPARE(refusal(), QString("pose-0002.lookat: is the eye itself: the camera looks nowhere"));
  const auto regionRefusal = [](const CameraRegionParams& region) {
    return errorOf([&] { check(region, "cameraRegion"); });
  };
  CameraRegionParams region;
  region.centre.z = 0.2;
  QCOMPARE(regionRefusal(region), QString());  // a plane
  region.region = RegionShape::box;
  QCOMPARE(regionRefusal(region),
           QString("cameraRegion.centre: brings the region to the panel or behind it: its z must "
                   "be above 0, and above half the depth of a box"));
  region = {};
  region.angle = {10, -10};
  QCOMPARE(regionRefusal(region),
           QString("cameraRegion.angle: ends before it begins: give [least, most]"));
}

QTEST_APPLESS_MAIN(TestCameraSet)
#include "test_camera_set.moc"
