// SPDX-License-Identifier: BSD-3-Clause
// Tests where a ray meets the display, in closed form, and that rayOf is the inverse.
#include <QTest>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/panel/display.h"
#include "tests/core/random.h"

using namespace hogelscope;

Q_DECLARE_METATYPE(hogelscope::Vec3)
Q_DECLARE_METATYPE(hogelscope::Hit)

namespace {

constexpr auto rectilinear = static_cast<int>(HogelLensModel::rectilinear);
constexpr auto equiangular = static_cast<int>(HogelLensModel::equiangular);

double tanDegrees(double angle) {
  return std::tan(angle * std::acos(-1.0) / 180);
}

PanelParams smallDisplay(int lens) {
  PanelParams params;
  params.size = {0.4, 0.2};
  params.hogels = {4, 2};
  params.directions = {8, 6};
  params.fov = {60, 40};
  params.lens = static_cast<HogelLensModel>(lens);
  return params;
}

bool near(const Hit& a, const Hit& b, double tolerance) {
  return std::abs(a.i - b.i) < tolerance && std::abs(a.j - b.j) < tolerance &&
         std::abs(a.u - b.u) < tolerance && std::abs(a.v - b.v) < tolerance;
}

}  // namespace

class TestDisplay : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void hit_data();
  void hit();
  void noHit_data();
  void noHit();
  void outsideTheFieldIsNoHit_data();
  void outsideTheFieldIsNoHit();
  void bordersBelongToTheNextCell();
  void rayOfIsTheInverse_data();
  void rayOfIsTheInverse();
  void fieldsCoincide();
  void rayOfByHand();
  void standsAtItsPose();
  void eyesAreSeenFromTheMiddle();
};

void TestDisplay::hit_data() {
  QTest::addColumn<int>("lens");
  QTest::addColumn<Vec3>("eye");
  QTest::addColumn<Vec3>("direction");
  QTest::addColumn<Hit>("expected");
  const auto row = [](const char* name, int lens, Vec3 eye, Vec3 direction, Hit expected) {
    QTest::newRow(name) << lens << eye << direction << expected;
  };
  const Vec3 ahead{0, 0, -1};
  row("centre", rectilinear, {0, 0, 1}, ahead, {2, 1, 4, 3});
  row("centre, equiangular", equiangular, {0, 0, 1}, ahead, {2, 1, 4, 3});
  row("i counts from the left", rectilinear, {-0.15, 0, 1}, ahead, {0.5, 1, 4, 3});
  row("j counts from the top", rectilinear, {0, 0.05, 1}, ahead, {2, 0.5, 4, 3});
  row("far away", rectilinear, {0.12, -0.03, 1e6}, ahead, {3.2, 1.3, 4, 3});
  const double right = tanDegrees(20);
  row("leaves to the right", rectilinear, {right, 0, 1}, {-right, 0, -1},
      {2, 1, 4 + 4 * right / tanDegrees(30), 3});
  row("leaves to the right, equiangular", equiangular, {right, 0, 1}, {-right, 0, -1},
      {2, 1, 4 + 8 * 20.0 / 60, 3});
  const double up = tanDegrees(10);
  row("leaves upwards", rectilinear, {0, up, 1}, {0, -up, -1},
      {2, 1, 4, 3 - 3 * up / tanDegrees(20)});
  row("leaves upwards, equiangular", equiangular, {0, up, 1}, {0, -up, -1},
      {2, 1, 4, 3 - 6 * 10.0 / 40});
  row("length does not matter", rectilinear, {0.5 * right, 0, 0.5}, {-9 * right, 0, -9},
      {2, 1, 4 + 4 * right / tanDegrees(30), 3});
  row("all at once", rectilinear, {0.1 + 2 * 0.3, -0.05 - 2 * 0.2, 2}, {-0.3, 0.2, -1},
      {3, 1.5, 4 + 4 * 0.3 / tanDegrees(30), 3 + 3 * 0.2 / tanDegrees(20)});
}

void TestDisplay::hit() {
  QFETCH(const int, lens);
  QFETCH(const Vec3, eye);
  QFETCH(const Vec3, direction);
  QFETCH(const Hit, expected);
  const auto found = Display(smallDisplay(lens)).hit(eye, direction);
  QVERIFY(found);
  QVERIFY(near(*found, expected, 1e-9));
}

void TestDisplay::noHit_data() {
  QTest::addColumn<Vec3>("eye");
  QTest::addColumn<Vec3>("direction");
  const auto row = [](const char* name, Vec3 eye, Vec3 direction) {
    QTest::newRow(name) << eye << direction;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  row("eye in the plane", {0, 0, 0}, {0, 0, -1});
  row("eye behind, looking at the panel", {0, 0, -1}, {0, 0, 1});
  row("eye behind, looking away", {0, 0, -1}, {0, 0, -1});
  row("looking away", {0, 0, 1}, {0, 0, 1});
  row("parallel to the panel", {0, 0, 1}, {1, 0, 0});
  row("nearly parallel", {0, 0, 1}, {1, 0, -5e-324});
  row("no direction", {0, 0, 1}, {0, 0, 0});
  row("left of the panel", {-0.201, 0, 1}, {0, 0, -1});
  row("right of the panel", {0.201, 0, 1}, {0, 0, -1});
  row("above the panel", {0, 0.101, 1}, {0, 0, -1});
  row("below the panel", {0, -0.101, 1}, {0, 0, -1});
  row("not a number", {nan, 0, 1}, {0, 0, -1});
  row("direction not a number", {0, 0, 1}, {0, nan, -1});
  row("infinitely far", {0, 0, infinite}, {0.1, 0, -1});
}

void TestDisplay::noHit() {
  QFETCH(const Vec3, eye);
  QFETCH(const Vec3, direction);
  QVERIFY(!Display(smallDisplay(rectilinear)).hit(eye, direction));
  QVERIFY(!Display(smallDisplay(equiangular)).hit(eye, direction));
}

void TestDisplay::outsideTheFieldIsNoHit_data() {
  QTest::addColumn<int>("lens");
  QTest::newRow("rectilinear") << rectilinear;
  QTest::newRow("equiangular") << equiangular;
}

void TestDisplay::outsideTheFieldIsNoHit() {
  QFETCH(const int, lens);
  const Display display(smallDisplay(lens));
  const auto seen = [&](double a, double b) {
    return display.hit({a, b, 1}, {-a, -b, -1}).has_value();
  };
  const double x = tanDegrees(30);
  const double y = tanDegrees(20);
  for (const double sign : {-1.0, 1.0}) {
    QVERIFY(seen(sign * x * 0.999999, 0));
    QVERIFY(!seen(sign * x * 1.000001, 0));
    QVERIFY(seen(0, sign * y * 0.999999));
    QVERIFY(!seen(0, sign * y * 1.000001));
  }
}

void TestDisplay::bordersBelongToTheNextCell() {
  PanelParams params = smallDisplay(rectilinear);
  params.size = {1, 1};  // its borders, and the rays through them, are exact
  const Display display(params);
  const auto at = [&](double x, double y) { return display.hit({x, y, 1}, {0, 0, -1}); };
  QVERIFY(at(-0.25, 0.25)->i == 1.0);
  QVERIFY(at(-0.25, 0)->j == 1.0);
  QVERIFY(at(0, 0)->u == 4.0 && at(0, 0)->v == 3.0);
  QVERIFY(at(-0.5, 0.5)->i == 0.0 && at(-0.5, 0.5)->j == 0.0);
  QVERIFY(!at(0.5, 0));
  QVERIFY(!at(0, -0.5));
  // u is exactly 0 at the one end of the field and exactly du at the other.
  const double edge = std::tan(radians(60) / 2);
  QVERIFY(display.hit({-edge, 0, 1}, {edge, 0, -1})->u == 0.0);
  QVERIFY(!display.hit({edge, 0, 1}, {-edge, 0, -1}));
}

void TestDisplay::rayOfIsTheInverse_data() {
  outsideTheFieldIsNoHit_data();
}

void TestDisplay::rayOfIsTheInverse() {
  QFETCH(const int, lens);
  Random random(4);
  for (int repeat = 0; repeat < 20; ++repeat) {
    PanelParams params = smallDisplay(lens);
    params.size = {random.uniform(0.01, 2), random.uniform(0.01, 2)};
    params.hogels = {random.integer(1, 6), random.integer(1, 6)};
    params.directions = {random.integer(1, 6), random.integer(1, 6)};
    params.fov = {random.uniform(1, 170), random.uniform(1, 170)};
    if (repeat % 2 == 0) params.viewingDistance = random.uniform(0.05, 5);
    const Display display(params);
    const auto [nx, ny, du, dv] = display.size();
    for (int k = 0; k < nx * ny * du * dv; ++k) {
      const TexelIndex at{k % nx, k / nx % ny, k / (nx * ny) % du, k / (nx * ny * du)};
      const auto [p, s] = display.rayOf(at);
      const double z = random.uniform(0.1, 3);
      const auto found = display.hit({p.x + z * s.x, p.y + z * s.y, z}, {-2 * s.x, -2 * s.y, -2});
      QVERIFY(found);
      QVERIFY(near(*found, {at.i + 0.5, at.j + 0.5, at.u + 0.5, at.v + 0.5}, 1e-9));
    }
  }
}

/// All hogels send a direction's light to one point of the plane at the viewing distance.
void TestDisplay::fieldsCoincide() {
  PanelParams params = smallDisplay(rectilinear);
  params.viewingDistance = 0.7;
  const Display display(params);
  const auto pointOf = [&](const TexelIndex& at) {
    const auto [p, s] = display.rayOf(at);
    return Vec2{p.x + 0.7 * s.x, p.y + 0.7 * s.y};
  };
  const Vec2 point = pointOf({0, 0, 6, 1});
  QVERIFY(std::abs(point.x - 0.7 * tanDegrees(30) * 5 / 8) < 1e-12);
  QVERIFY(std::abs(point.y - 0.7 * tanDegrees(20) * 3 / 6) < 1e-12);
  for (const TexelIndex& at : {TexelIndex{3, 0, 6, 1}, {1, 1, 6, 1}, {2, 1, 6, 1}}) {
    QVERIFY(std::abs(pointOf(at).x - point.x) < 1e-12);
    QVERIFY(std::abs(pointOf(at).y - point.y) < 1e-12);
  }
}

void TestDisplay::rayOfByHand() {
  const auto [p, s] = Display(smallDisplay(rectilinear)).rayOf({0, 0, 7, 0});
  QVERIFY(std::abs(p.x + 0.15) < 1e-15 && std::abs(p.y - 0.05) < 1e-15);
  QVERIFY(std::abs(s.x - tanDegrees(30) * 7 / 8) < 1e-15);
  QVERIFY(std::abs(s.y - tanDegrees(20) * 5 / 6) < 1e-15);
  const auto angular = Display(smallDisplay(equiangular)).rayOf({0, 0, 7, 0}).slopes;
  QVERIFY(std::abs(angular.x - tanDegrees(30.0 * 7 / 8)) < 1e-15);
  QVERIFY(std::abs(angular.y - tanDegrees(20.0 * 5 / 6)) < 1e-15);
}

void TestDisplay::standsAtItsPose() {
  PanelParams params = smallDisplay(rectilinear);
  params.position = {1, 2, 3};
  params.orientation = {0, 90, 0};  // faces +x
  const Display display(params);
  const Vec3 inFront = display.displayFromWorld().point({2, 2, 3});
  QVERIFY(length(inFront - Vec3{0, 0, 1}) < 1e-15);
  QVERIFY((display.size() == LightFieldSize{4, 2, 8, 6}));
}

/// The panel stands at (1, 2, 3) and looks along the world's +x.
void TestDisplay::eyesAreSeenFromTheMiddle() {
  DisplayParams display;
  display.position = {1, 2, 3};
  display.orientation = {0, 90, 0};
  const auto isAt = [&](const Vec3& eye, double distance, double angle) {
    const EyePlace place = eyePlaceOf(display, eye);
    return std::abs(place.distance - distance) < 1e-12 && std::abs(place.angle - angle) < 1e-9;
  };
  QVERIFY(isAt({1.5, 2, 3}, 0.5, 0));
  QVERIFY(isAt({1.5, 2.5, 3}, std::sqrt(0.5), 45));
  QVERIFY(isAt({1.3, 2, 2.6}, 0.5, 180 / std::numbers::pi * std::acos(0.6)));
  QVERIFY(isAt({1, 2, 5}, 2, 90));
  QVERIFY(isAt({0, 2, 3}, 1, 180));
  const Vec3 point = eyePlaceOf(display, {1.5, 2.2, 2.9}).point;
  QVERIFY(std::abs(point.x - 0.1) < 1e-12 && std::abs(point.y - 0.2) < 1e-12 &&
          std::abs(point.z - 0.5) < 1e-12);
}

QTEST_APPLESS_MAIN(TestDisplay)
#include "test_display.moc"
