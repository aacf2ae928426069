// SPDX-License-Identifier: BSD-3-Clause
// What a display can show to an eye: against closed forms, and against the light's own geometry.
#include <QtTest>

#include "core/panel/design_numbers.h"
#include "tests/core/random_scene.h"

using namespace hogelscope;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The display of the mock-ups: 0.5 m, 256 hogels and 150 directions a side, 60°.
PanelParams squareDisplay() {
  PanelParams display;
  display.hogels = {256, 256};
  display.directions = {150, 150};
  return display;
}

bool isNear(double a, double b, double relative = 1e-9) {
  return a == b || std::abs(a - b) <= relative * std::abs(b);
}

/// Whether the eye at (0, 0, distance) looks past the two edges of the middle direction's light, on
/// the plane z, at places of the panel that are at most one hogel apart.
bool isSharp(const Display& display, double z, double distance) {
  const auto [nx, ny, du, dv] = display.size();
  const auto placeOf = [&](double edge) {
    const Vec2 slopes = display.slopes(0.5 * du + edge, 0.5 * dv + edge);
    return *display.intersectPlane({0, 0, distance}, {z * slopes.x, z * slopes.y, z - distance});
  };
  const Hit a = placeOf(-0.5);
  const Hit b = placeOf(0.5);
  return (du == 1 || std::abs(a.i - b.i) <= 1) && (dv == 1 || std::abs(a.j - b.j) <= 1);
}

/// Returns the depth, from `side` · 0 on, where isSharp() ends; it is searched in small steps.
double searched(const Display& display, double side, double distance, double farthest) {
  constexpr int steps = 200000;
  for (int k = 1; k < steps; ++k)
    if (const double z = farthest * k / steps; !isSharp(display, side * z, distance)) return z;
  return infinite;
}

}  // namespace

class TestDesignNumbers : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void areClosedForms() {
    const DesignNumbers n = designNumbers(squareDisplay(), {-0.09, 0.05, 0.56});
    const double p = 0.5 / 256;
    const double s = 2 * std::tan(radians(30)) / 150;
    const double d = 0.56;
    for (const std::size_t axis : {0, 1}) {
      QVERIFY(isNear(n.hogelPitch[axis], p));
      QVERIFY(isNear(n.slopeStep[axis], s));
      QVERIFY(isNear(n.degreesPerDirection[axis], 2 * std::atan(s / 2) / radians(1)));
      QVERIFY(isNear(n.hogelArcmin[axis], 60 * 2 * std::atan(p / 2 / d) / radians(1)));
      QVERIFY(isNear(n.directionsPerPupil[axis], 0.004 / (d * s)));
    }
    QCOMPARE(n.distance, d);
    QVERIFY(isNear(n.megapixels, 1474.56));
    QVERIFY(isNear(n.depthFront, p * d / (s * d + p)));
    QVERIFY(isNear(n.depthBehind, p * d / (s * d - p)));
    // The same as figures of the mock-up: 12.0′, 0.44°, 0.93, −46 cm.
    QVERIFY(std::abs(n.hogelArcmin[0] - 12.0) < 0.05);
    QVERIFY(std::abs(n.degreesPerDirection[0] - 0.44) < 0.005);
    QVERIFY(std::abs(n.directionsPerPupil[0] - 0.93) < 0.005);
    QVERIFY(std::abs(n.depthBehind - 0.46) < 0.005);
  }

  /// A direction of an equiangular lens is an even share of the field, and wider in slope than
  /// tan(F/2)/du·2 says of a rectilinear one.
  void theLensDecides() {
    PanelParams display = squareDisplay();
    display.directions = {20, 4};
    display.fov = {120, 90};
    const DesignNumbers even = designNumbers(display, {0, 0, 1});
    QVERIFY(isNear(even.degreesPerDirection[0],
                   2 * std::atan(std::tan(radians(60)) / 20) * (180 / std::numbers::pi)));
    display.lens = HogelLensModel::equiangular;
    const DesignNumbers angular = designNumbers(display, {0, 0, 1});
    QVERIFY(isNear(angular.degreesPerDirection[0], 6));
    QVERIFY(isNear(angular.degreesPerDirection[1], 22.5));
    QVERIFY(isNear(angular.slopeStep[0], 2 * std::tan(radians(3))));
    QVERIFY(angular.slopeStep[0] < even.slopeStep[0]);
  }

  void depthsAreThoseOfTheLight() {
    Random random(37);
    int limited = 0;
    for (int k = 0; k < 40; ++k) {
      PanelParams display = randomDisplay(random);
      display.viewingDistance = notGiven;
      const double distance = random.uniform(0.2, 2);
      const Vec3 eye =
          transformFromPose(display.position, display.orientation).point({0.1, -0.2, distance});
      const DesignNumbers n = designNumbers(display, eye);
      QVERIFY(isNear(n.distance, distance));
      const Display shown(display);
      if (display.directions == std::array{1, 1}) continue;
      QVERIFY(
          isNear(searched(shown, 1, distance, distance), n.depthFront, 1e-3 + 1e-5 / n.depthFront));
      constexpr double far = 50;
      const double behind = searched(shown, -1, distance, far);
      if (n.depthBehind < far) {
        ++limited;
        QVERIFY(std::abs(behind - n.depthBehind) <= far / 200000 * 1.01);
      } else {
        QCOMPARE(behind, infinite);
      }
    }
    QVERIFY(limited > 10 && limited < 40);
  }

  void depthsWithoutALimit() {
    PanelParams display = squareDisplay();
    display.directions = {1000, 1000};
    const DesignNumbers fine = designNumbers(display, {0, 0, 0.5});  // s D < p
    QCOMPARE(fine.depthBehind, infinite);
    QVERIFY(fine.depthFront > 0.25 && fine.depthFront < 0.5);
    // A display with parallax across alone: rows of one direction blur nothing.
    display.directions = {150, 1};
    const DesignNumbers across = designNumbers(display, {0, 0, 0.56});
    QCOMPARE(across.depthBehind, designNumbers(squareDisplay(), {0, 0, 0.56}).depthBehind);
    display.directions = {1, 1};
    const DesignNumbers plain = designNumbers(display, {0, 0, 0.56});
    QCOMPARE(plain.depthFront, 0.56);
    QCOMPARE(plain.depthBehind, infinite);
  }

  void behindThePanelNothingIsSeen() {
    const DesignNumbers n = designNumbers(squareDisplay(), {0, 0, -1});
    QCOMPARE(n.distance, 0.0);
    QCOMPARE(n.depthFront, 0.0);
    QCOMPARE(n.hogelArcmin[0], 0.0);
    QVERIFY(n.hogelPitch[0] > 0);
  }

  /// In dioptres the sharp depths are as far in front as behind: p/(s D²).
  void dioptres() {
    const double d = 0.56;
    const DesignNumbers n = designNumbers(squareDisplay(), {0, 0, d});
    const double limit = n.hogelPitch[0] / (n.slopeStep[0] * d * d);
    QVERIFY(isNear(dioptresAt(n.depthFront, d), limit));
    QVERIFY(isNear(dioptresAt(-n.depthBehind, d), -limit));
    QCOMPARE(dioptresAt(0, d), 0.0);
    QVERIFY(isNear(dioptresAt(-infinite, d), -1 / d));
  }

  void thePitchIsHeld() {
    DisplayParams before = squareDisplay();
    before.size = {0.5, 0.3};
    DisplayParams after = before;
    after.hogels = {512, 64};
    holdPitch(before, after);
    QCOMPARE(after.size, (std::array{1.0, 0.075}));
    after.hogels = {0, 256};  // left out: nothing is known of it
    const auto size = after.size;
    holdPitch(before, after);
    QCOMPARE(after.size[0], size[0]);
    before.hogels = {0, 0};
    after.hogels = {10, 10};
    holdPitch(before, after);
    QCOMPARE(after.size[1], size[1]);
  }

  void theNumberOfPixelsIsHeld() {
    DisplayParams before = squareDisplay();
    before.hogels = {200, 100};
    before.directions = {30, 20};
    DisplayParams after = before;
    after.hogels = {400, 300};
    holdPixels(before, after);
    QCOMPARE(after.directions, (std::array{15, 7}));  // 20/3 is rounded
    QCOMPARE(after.hogels, (std::array{400, 300}));
    after = before;
    after.directions = {60, 10};
    holdPixels(before, after);
    QCOMPARE(after.hogels, (std::array{100, 200}));
    before.directions = {30, 1};  // of a sheet of cylinders
    after = before;
    after.hogels = {100, 50};
    holdPixels(before, after);
    QCOMPARE(after.directions, (std::array{60, 1}));
    after = before;
    after.hogels = {0, 0};  // left out: nothing is known of them
    holdPixels(before, after);
    QCOMPARE(after.directions, before.directions);
    after.hogels = {100000, 100};  // never none
    holdPixels(before, after);
    QCOMPARE(after.directions, (std::array{1, 1}));
  }
};

QTEST_APPLESS_MAIN(TestDesignNumbers)
#include "test_design_numbers.moc"
