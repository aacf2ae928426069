// SPDX-License-Identifier: BSD-3-Clause
// Tests camera sets: their laws (Kolmogorov-Smirnov), grids, arcs, look-at, names, templates, and
// that a seed means the same on every machine.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include "core/camera_set.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

constexpr std::array<double, 2> panel{0.5, 0.3};

using Law = std::function<double(double)>;

/// The largest distance between the samples' distribution and the law, times √n.
double kolmogorovSmirnov(std::vector<double> samples, const Law& law) {
  std::sort(samples.begin(), samples.end());
  const auto n = double(samples.size());
  double worst = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double expected = law(samples[k]);
    worst = std::max({worst, expected - double(k) / n, double(k + 1) / n - expected});
  }
  return std::sqrt(n) * worst;
}

/// Exceeded by one sample of the law in 10 000: 2 exp(-2 t²) = 1e-4.
constexpr double limit = 2.23;

Law uniformLaw(double low, double high) {
  return [=](double x) { return std::clamp((x - low) / (high - low), 0.0, 1.0); };
}

/// A Gaussian about the middle of [low, high] with `deviation` times its width, truncated to it.
Law normalLaw(double low, double high, double deviation) {
  const auto phi = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
  const double sigma = deviation * (high - low);
  const double middle = (low + high) / 2;
  const double below = phi((low - middle) / sigma);
  const double above = phi((high - middle) / sigma);
  return [=](double x) { return (phi((x - middle) / sigma) - below) / (above - below); };
}

struct Coordinates {
  std::array<std::vector<double>, 3> of;
};

/// x, y, z, or of an arc: angle, elevation (degrees), distance.
Coordinates coordinatesOf(const std::vector<CameraPose>& poses, RegionShape region) {
  Coordinates list;
  for (const CameraPose& pose : poses) {
    Vec3 at = pose.eye;
    if (region == RegionShape::arc) {
      const double degrees = 180 / std::acos(-1.0);
      at = {std::atan2(pose.eye.x, pose.eye.z) * degrees,
            std::asin(pose.eye.y / length(pose.eye)) * degrees, length(pose.eye)};
    }
    list.of[0].push_back(at.x);
    list.of[1].push_back(at.y);
    list.of[2].push_back(at.z);
  }
  return list;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = double(a.size());
  const double meanA = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double meanB = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double ab = 0;
  double aa = 0;
  double bb = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - meanA) * (b[k] - meanB);
    aa += (a[k] - meanA) * (a[k] - meanA);
    bb += (b[k] - meanB) * (b[k] - meanB);
  }
  return ab / std::sqrt(aa * bb);
}

CameraSet boxSet(CameraSpread distribution, int count) {
  CameraSet set;
  set.params.count = count;
  set.region.distribution = distribution;
  set.region.region = RegionShape::box;
  set.region.centre = {0.1, -0.2, 0.7};
  set.region.extent = {0.6, 0.2, 0.4};
  return set;
}

CameraSet arcSet(CameraSpread distribution, int count) {
  CameraSet set = boxSet(distribution, count);
  set.region.region = RegionShape::arc;
  set.region.angle = {-40, 20};
  set.region.elevation = {5, 15};
  set.region.distance = {0.4, 0.9};
  return set;
}

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

bool near(const Vec3& a, const Vec3& b, double tolerance) {
  return length(a - b) <= tolerance;
}

}  // namespace

class TestCameraSet : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lawOfEachSide_data();
  void lawOfEachSide();
  void theTestSeesAnotherLaw();
  void gridSizes_data();
  void gridSizes();
  void gridReachesTheEnds();
  void gridIsCutEvenly();
  void arcIsAnArc();
  void lookatOnThePanel();
  void jitterIsUniform();
  void sameOnEveryMachine();
  void moreStatesBeginAlike();
  void mixtureShares();
  void pathStepsAreEqual();
  void traceWeighsByTime();
  void statesAreTheTemplates();
  void statesStandInFrontOfATurnedPanel();
  void namesSortAndAreUnique();
  void badSets();
};

void TestCameraSet::lawOfEachSide_data() {
  QTest::addColumn<bool>("isArc");
  QTest::addColumn<double>("deviation");  // 0: uniform
  QTest::newRow("box, random") << false << 0.0;
  QTest::newRow("box, normal") << false << 0.25;
  QTest::newRow("box, normal, mostly cut off") << false << 1.0;
  QTest::newRow("box, normal, narrow") << false << 0.05;
  QTest::newRow("arc, random") << true << 0.0;
  QTest::newRow("arc, normal") << true << 0.3;
}

void TestCameraSet::lawOfEachSide() {
  QFETCH(const bool, isArc);
  QFETCH(const double, deviation);
  const CameraSpread spread = deviation == 0 ? CameraSpread::random : CameraSpread::normal;
  CameraSet set = isArc ? arcSet(spread, 20000) : boxSet(spread, 20000);
  if (deviation > 0) set.region.deviation = deviation;
  const Coordinates found = coordinatesOf(posesOf(set, panel), set.region.region);
  const std::array<std::array<double, 2>, 3> ends =
      isArc ? std::array<std::array<double, 2>, 3>{{{-40, 20}, {5, 15}, {0.4, 0.9}}}
            : std::array<std::array<double, 2>, 3>{{{-0.2, 0.4}, {-0.3, -0.1}, {0.5, 0.9}}};
  for (std::size_t side = 0; side < 3; ++side) {
    const auto [low, high] = ends[side];
    const Law law = deviation == 0 ? uniformLaw(low, high) : normalLaw(low, high, deviation);
    const double distance = kolmogorovSmirnov(found.of[side], law);
    QVERIFY2(distance < limit, qPrintable(QString("side %1: %2").arg(side).arg(distance)));
    const double together = correlation(found.of[side], found.of[(side + 1) % 3]);
    QVERIFY2(std::abs(together) < 4 / std::sqrt(20000.0), qPrintable(QString::number(together)));
  }
}

void TestCameraSet::theTestSeesAnotherLaw() {
  const CameraSet set = boxSet(CameraSpread::normal, 20000);
  const Coordinates found = coordinatesOf(posesOf(set, panel), RegionShape::box);
  QVERIFY(kolmogorovSmirnov(found.of[0], normalLaw(-0.2, 0.4, 0.3)) > limit);
  QVERIFY(kolmogorovSmirnov(found.of[0], uniformLaw(-0.2, 0.4)) > limit);
}

void TestCameraSet::gridSizes_data() {
  QTest::addColumn<RegionShape>("region");
  QTest::addColumn<QList<double>>("extent");
  QTest::addColumn<int>("count");
  QTest::addColumn<QList<int>>("size");
  const auto row = [](const char* name, RegionShape region, const QList<double>& extent, int count,
                      const QList<int>& size) {
    QTest::newRow(name) << region << extent << count << size;
  };
  row("square", RegionShape::plane, {1, 1, 1}, 9, {3, 3, 1});
  row("wide", RegionShape::plane, {2, 1, 1}, 8, {4, 2, 1});
  row("tall", RegionShape::plane, {1, 2, 1}, 8, {2, 4, 1});
  row("ten", RegionShape::plane, {1, 1, 1}, 10, {4, 3, 1});
  row("one", RegionShape::plane, {1, 1, 1}, 1, {1, 1, 1});
  row("prime", RegionShape::plane, {1, 1, 1}, 97, {10, 10, 1});
  row("row", RegionShape::plane, {1, 0, 1}, 7, {7, 1, 1});
  row("column", RegionShape::plane, {0, 1, 1}, 7, {1, 7, 1});
  row("point", RegionShape::plane, {0, 0, 1}, 7, {7, 1, 1});
  row("cube", RegionShape::box, {1, 1, 1}, 27, {3, 3, 3});
  row("bar", RegionShape::box, {4, 1, 1}, 32, {8, 2, 2});
  row("depths only", RegionShape::box, {0, 0, 1}, 5, {1, 1, 5});
  row("many", RegionShape::box, {1, 1, 1}, 100000, {47, 47, 46});
}

void TestCameraSet::gridSizes() {
  QFETCH(const RegionShape, region);
  QFETCH(const QList<double>, extent);
  QFETCH(const int, count);
  QFETCH(const QList<int>, size);
  CameraRegionParams params;
  params.region = region;
  params.centre.z = 10;
  params.extent = {extent[0], extent[1], extent[2]};
  const GridSize grid = gridFor(params, count);
  QCOMPARE((QList<int>{grid.columns, grid.rows, grid.layers}), size);
}

void TestCameraSet::gridReachesTheEnds() {
  CameraSet set = boxSet(CameraSpread::uniform, 24);
  set.region.extent = {0.3, 0.2, 0.1};  // cells of 0.1/1.5…: 4×3×2
  const std::vector<CameraPose> poses = posesOf(set, panel);
  const GridSize grid = gridFor(set.region, 24);
  QCOMPARE(grid, (GridSize{4, 3, 2}));
  for (int k = 0; k < 24; ++k) {
    const Vec3 expected{0.1 - 0.15 + 0.1 * (k % 4), -0.2 + 0.1 - 0.1 * (k / 4 % 3),
                        0.65 + 0.1 * (k / 12)};
    QVERIFY(near(poses[std::size_t(k)].eye, expected, 1e-12));
  }
}

void TestCameraSet::gridIsCutEvenly() {
  CameraSet set = boxSet(CameraSpread::uniform, 10);
  set.region.region = RegionShape::plane;
  set.region.extent = {0.3, 0.3, 0};
  const std::vector<CameraPose> poses = posesOf(set, panel);
  QCOMPARE(poses.size(), std::size_t(10));
  const std::array<int, 10> taken{0, 1, 3, 4, 5, 6, 7, 9, 10, 11};  // of 4×3
  for (std::size_t k = 0; k < 10; ++k) {
    const Vec3 expected{-0.05 + 0.1 * (taken[k] % 4), -0.05 - 0.15 * (taken[k] / 4), 0.7};
    QVERIFY(near(poses[k].eye, expected, 1e-12));
  }
}

void TestCameraSet::arcIsAnArc() {
  CameraSet set;
  set.params.count = 5;
  set.region.region = RegionShape::arc;
  set.region.lookat = LookAt::nearest;
  set.region.distance = {0.8, 0.8};
  set.region.angle = {-60, 60};
  const std::vector<CameraPose> poses = posesOf(set, panel);
  for (int k = 0; k < 5; ++k) {
    const CameraPose& pose = poses[std::size_t(k)];
    const double angle = radians(-60 + 30 * k);
    QVERIFY(near(pose.eye, {0.8 * std::sin(angle), 0, 0.8 * std::cos(angle)}, 1e-15));
    QVERIFY(near(pose.lookat, {std::clamp(pose.eye.x, -0.25, 0.25), 0, 0}, 0));
  }
  set.region.distribution = CameraSpread::random;
  set.params.count = 1000;
  for (const CameraPose& pose : posesOf(set, panel)) {
    QVERIFY(std::abs(length(pose.eye) - 0.8) < 1e-15);
    QCOMPARE(pose.eye.y, 0.0);
    QVERIFY(std::abs(std::atan2(pose.eye.x, pose.eye.z)) <= radians(60) + 1e-15);
  }
}

/// No other point of the panel is nearer.
void TestCameraSet::lookatOnThePanel() {
  CameraSet set = boxSet(CameraSpread::random, 50);
  set.region.extent = {2, 2, 0.4};
  set.region.lookat = LookAt::nearest;
  for (const CameraPose& pose : posesOf(set, panel)) {
    QVERIFY(pose.lookat.z == 0 && std::abs(pose.lookat.x) <= 0.25);
    QVERIFY(std::abs(pose.lookat.y) <= 0.15);
    const double distance = length(pose.eye - pose.lookat);
    for (int k = 0; k <= 20; ++k)
      for (int j = 0; j <= 20; ++j)
        QVERIFY(length(pose.eye - Vec3{-0.25 + 0.025 * k, -0.15 + 0.015 * j, 0}) >=
                distance - 1e-12);
  }
}

void TestCameraSet::jitterIsUniform() {
  CameraSet set = boxSet(CameraSpread::uniform, 20000);
  set.region.lookat = LookAt::jittered;
  set.region.target = {0.1, 0.2, -0.3};
  set.region.jitter = 0.05;
  std::vector<double> x;
  std::vector<double> y;
  for (const CameraPose& pose : posesOf(set, panel)) {
    x.push_back(pose.lookat.x);
    y.push_back(pose.lookat.y);
    QCOMPARE(pose.lookat.z, -0.3);
  }
  QVERIFY(kolmogorovSmirnov(x, uniformLaw(0.05, 0.15)) < limit);
  QVERIFY(kolmogorovSmirnov(y, uniformLaw(0.15, 0.25)) < limit);
}

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
  set.source = Trace{{{10, {0, 0, 1}}, {14, {0, 0, 1}}, {16, {1, 0, 1}}, {18, {1, 0, 1}}}};
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
  const Display display(session.display);
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

void TestCameraSet::badSets() {
  const Session session = sampleSession();
  CameraSet set = boxSet(CameraSpread::uniform, 2);
  const auto refusal = [&] { return errorOf([&] { (void)withCameras(session, set); }); };
  set.params.templateState = "third";
  QCOMPARE(refusal(), QString("cameraSet.template: \"third\" is no state of the session"));
  set.params.templateState = "";
  set.params.name = "a/b";
  QCOMPARE(refusal(), QString("cameraSet.name: \"a/b-0001\" has a slash or a control character; it "
                              "names the picture's file"));
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
