// SPDX-License-Identifier: BSD-3-Clause
// The share of the panel that lights an eye: against counting its places ray by ray.
#include <QtTest>

#include "core/panel/viewing_zone.h"
#include "tests/core/random_scene.h"

using namespace hogelscope;

namespace {

/// Of n × n places of the panel, the share whose ray to the eye hits the display.
double counted(const PanelParams& params, const Vec3& eye, int n) {
  const Display display(params);
  const Vec3 e = display.displayFromWorld().point(eye);
  int seen = 0;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const Vec3 place{((x + 0.5) / n - 0.5) * params.size[0],
                       ((y + 0.5) / n - 0.5) * params.size[1], 0};
      if (display.hit(e, place - e)) ++seen;
    }
  }
  return double(seen) / (n * n);
}

}  // namespace

class TestViewingZone : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isWhatIsCounted() {
    Random random(31);
    int all = 0;
    int none = 0;
    int part = 0;
    for (int k = 0; k < 400; ++k) {
      const PanelParams display = randomDisplay(random);
      const double size = std::max(display.size[0], display.size[1]);
      const Vec3 eye = transformFromPose(display.position, display.orientation)
                           .point({random.uniform(-2, 2) * size, random.uniform(-2, 2) * size,
                                   random.uniform(-0.3, 3) * size});
      constexpr int n = 100;
      const double share = shareSeenFrom(display, eye);
      // Counting is a place off at each of the four borders.
      QVERIFY(std::abs(share - counted(display, eye, n)) <= 2.0 / n);
      share == 0 ? ++none : share == 1 ? ++all : ++part;
    }
    QVERIFY(all > 20 && none > 20 && part > 20);
  }

  void isClosedForm() {
    PanelParams display;  // 0.5 m × 0.5 m, 60°
    display.fov = {90, 90};
    QCOMPARE(shareSeenFrom(display, {0, 0, 0.25}), 1.0);
    QCOMPARE(shareSeenFrom(display, {0, 0, 0.125}), 0.25);
    QCOMPARE(shareSeenFrom(display, {0.5, 0, 0.25}), 0.0);
    QCOMPARE(shareSeenFrom(display, {0.375, 0, 0.25}), 0.25);
    QCOMPARE(shareSeenFrom(display, {0, 0, 0}), 0.0);
    QCOMPARE(shareSeenFrom(display, {0, 0, -1}), 0.0);
    display.viewingDistance = 1;  // where the whole field sees the whole panel, and nothing else
    QCOMPARE(shareSeenFrom(display, {0.99, 0, 1}), 1.0);
    QCOMPARE(shareSeenFrom(display, {1.01, 0, 1}), 0.0);
    QCOMPARE(shareSeenFrom(display, {0, 0, 0.5}), 1.0);
    QCOMPARE(shareSeenFrom(display, {0.75, 0, 0.5}), 0.0);
    QCOMPARE(shareSeenFrom(display, {2, 0, 2}), 0.5);
  }

  /// Points in and out of the zones see as much of the panel as they should.
  void sectionsAreTheZones() {
    Random random(32);
    std::array<int, 4> points{};
    for (int k = 0; k < 400; ++k) {
      const PanelParams display = randomDisplay(random);
      const RigidTransform worldFromDisplay =
          transformFromPose(display.position, display.orientation);
      const double far = random.uniform(0.1, 4) * display.size[0];
      for (const ViewingZone zone : {ViewingZone::someOfThePanel, ViewingZone::wholePanel}) {
        const std::vector<ZoneSection> sections = sectionsOf(display, zone, far);
        QVERIFY(zone == ViewingZone::wholePanel || sections.size() > 1);
        for (int n = 0; n < 50; ++n) {
          const double z = random.uniform(0, 1) * far;
          std::optional<ZoneSection> at;
          for (std::size_t s = 1; s < sections.size(); ++s) {
            const ZoneSection& a = sections[s - 1];
            const ZoneSection& b = sections[s];
            if (z < a.z || z > b.z) continue;
            const double t = (z - a.z) / (b.z - a.z);
            at = a;
            for (const std::size_t axis : {0U, 1U}) {
              at->low[axis] += t * (b.low[axis] - a.low[axis]);
              at->high[axis] += t * (b.high[axis] - a.high[axis]);
            }
          }
          const double x = random.uniform(-1, 1) * (display.size[0] + z);
          const double y = random.uniform(-1, 1) * (display.size[1] + z);
          const bool isInside =
              at && at->low[0] < x && x < at->high[0] && at->low[1] < y && y < at->high[1];
          const double share = shareSeenFrom(display, worldFromDisplay.point({x, y, z}));
          const double least = zone == ViewingZone::wholePanel ? 1 - 1e-9 : 1e-12;
          QCOMPARE(isInside, share > least);
          ++points[2 * std::size_t(zone) + isInside];
        }
      }
    }
    QVERIFY(*std::min_element(points.begin(), points.end()) > 500);
  }

  /// The outline's corners are as far in front as the point, and just inside them the whole panel,
  /// or a part of it, is seen, and just outside it is not.
  void outlinesAtAPoint() {
    Random random(33);
    int outlines = 0;
    for (int k = 0; k < 400; ++k) {
      const PanelParams display = randomDisplay(random);
      const RigidTransform worldFromDisplay =
          transformFromPose(display.position, display.orientation);
      const Vec3 local{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.5, 4)};
      const Vec3 point = worldFromDisplay.point(display.size[0] * local);
      for (const ViewingZone zone : {ViewingZone::someOfThePanel, ViewingZone::wholePanel}) {
        const double least = zone == ViewingZone::wholePanel ? 1 - 1e-9 : 1e-12;
        const std::vector<Vec3> corners = zoneAt(display, zone, point);
        if (corners.empty()) {
          QVERIFY(zone == ViewingZone::wholePanel || local.z <= 0);
          continue;
        }
        ++outlines;
        QCOMPARE(corners.size(), std::size_t(4));
        const Vec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
        for (const Vec3& corner : corners) {
          const double z = worldFromDisplay.inverse().point(corner).z;
          QVERIFY(std::abs(z - display.size[0] * local.z) < 1e-9);
          const Vec3 way = corner - middle;
          QVERIFY(shareSeenFrom(display, middle + 0.999 * way) > least);
          QVERIFY(!(shareSeenFrom(display, middle + 1.001 * way) > least));
        }
      }
    }
    QVERIFY2(outlines > 300, qPrintable(QString::number(outlines)));
  }
};

QTEST_APPLESS_MAIN(TestViewingZone)
#include "test_viewing_zone.moc"
