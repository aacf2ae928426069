// SPDX-License-Identifier: BSD-3-Clause
// Tests where the cameras of a set stand and look: laws (Kolmogorov-Smirnov), grids, arcs, look-at.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "tests/core/camera_sets.h"

using namespace hogelscope;

namespace {

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

}  // namespace

class TestCameraRegion : public QObject {
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
};

void TestCameraRegion::lawOfEachSide_data() {
  QTest::addColumn<bool>("isArc");
  QTest::addColumn<double>("deviation");  // 0: uniform
  QTest::newRow("box, random") << false << 0.0;
  QTest::newRow("box, normal") << false << 0.25;
  QTest::newRow("box, normal, mostly cut off") << false << 1.0;
  QTest::newRow("box, normal, narrow") << false << 0.05;
  QTest::newRow("arc, random") << true << 0.0;
  QTest::newRow("arc, normal") << true << 0.3;
}

void TestCameraRegion::lawOfEachSide() {
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

void TestCameraRegion::theTestSeesAnotherLaw() {
  const CameraSet set = boxSet(CameraSpread::normal, 20000);
  const Coordinates found = coordinatesOf(posesOf(set, panel), RegionShape::box);
  QVERIFY(kolmogorovSmirnov(found.of[0], normalLaw(-0.2, 0.4, 0.3)) > limit);
  QVERIFY(kolmogorovSmirnov(found.of[0], uniformLaw(-0.2, 0.4)) > limit);
}

void TestCameraRegion::gridSizes_data() {
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

void TestCameraRegion::gridSizes() {
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

void TestCameraRegion::gridReachesTheEnds() {
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

void TestCameraRegion::gridIsCutEvenly() {
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

void TestCameraRegion::arcIsAnArc() {
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
void TestCameraRegion::lookatOnThePanel() {
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

void TestCameraRegion::jitterIsUniform() {
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

QTEST_APPLESS_MAIN(TestCameraRegion)
#include "test_camera_region.moc"
