// SPDX-License-Identifier: BSD-3-Clause
// The drawing of a lens: its lines against the model's formula, its fold against closed forms.
#include "core/lens/lens_grid.h"

#include <QTest>
#include <algorithm>
#include <cmath>

using namespace hogelscope;

namespace {

LensKey lensOf(const DistortionParams& distortion, LensMapping mapping = LensMapping::exact) {
  LensKey key;
  key.distortion = distortion;
  key.mapping = mapping;
  key.res = {640, 480};
  key.focalLength = {500, 520};
  key.centre = {310, 250};
  return key;
}

constexpr double square = 480.0 / 520 / 10;

/// How far a number is from the nearest grid line.
double missOf(double world) {
  return std::abs(world - square * std::round(world / square));
}

}  // namespace

class TestLensGrid : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aPinholesLinesAreStraight() {
    const LensGrid grid = lensGrid(lensOf({}));
    QVERIFY(grid.fold.empty());
    QVERIFY(grid.lines.size() >= 20);
    for (const std::vector<Vec2>& line : grid.lines) {
      const Vec2 step{line.back().x - line.front().x, line.back().y - line.front().y};
      QVERIFY((step.x == 0) != (step.y == 0));
      const Vec2 at{(line.front().x - 310) / 500, (line.front().y - 250) / 520};
      QVERIFY(missOf(step.x == 0 ? at.x : at.y) < 1e-12);
    }
  }

  /// The image's points, taken back by a root found by bisection along the radius, lie on the
  /// grid.
  void aBarrelsLinesAreTheModels() {
    const double k1 = -0.2;
    const LensGrid grid = lensGrid(lensOf({k1, 0, 0, 0, 0}));
    double widest = 0;
    for (const std::vector<Vec2>& line : grid.lines)
      for (const Vec2& point : line) {
        const Vec2 shown{(point.x - 310) / 500, (point.y - 250) / 520};
        const double r = std::hypot(shown.x, shown.y);
        double low = 0;
        double high = std::sqrt(1 / (3 * -k1));  // where r (1 + k1 r²) stops growing
        for (int k = 0; k < 60; ++k) {
          const double middle = (low + high) / 2;
          (middle * (1 + k1 * middle * middle) < r ? low : high) = middle;
        }
        const double scale = r > 0 ? low / r : 1;
        // Near the fold the root is as uncertain as rounding's square root.
        QVERIFY(std::min(missOf(scale * shown.x), missOf(scale * shown.y)) < 1e-6);
        widest = std::max(widest, low);
      }
    QVERIFY(widest > 0.7);  // the corners of the image are reached
  }

  /// r (1 + k1 r²) grows until r = 1 / √(-3 k1), where it is 2/3 of that.
  void theFoldIsACircleOfAKnownRadius() {
    const double k1 = -1;
    const LensGrid grid = lensGrid(lensOf({k1, 0, 0, 0, 0}));
    const double expected = 2.0 / 3 / std::sqrt(-3 * k1);
    QCOMPARE(grid.fold.size(), std::size_t(128));
    for (const Vec2& point : grid.fold)
      QVERIFY(std::abs(std::hypot((point.x - 310) / 500, (point.y - 250) / 520) - expected) < 1e-5);
    // No line goes beyond it, and some come near it.
    double farthest = 0;
    for (const std::vector<Vec2>& line : grid.lines)
      for (const Vec2& point : line)
        farthest = std::max(farthest, std::hypot((point.x - 310) / 500, (point.y - 250) / 520));
    QVERIFY(farthest <= expected + 1e-9);
    QVERIFY(farthest > 0.97 * expected);
  }

  void aFoldOutsideThePictureIsNone() {
    // It is at 2/3 / √(0.3) = 1.217 in the image's plane; the farthest corner is at 0.81.
    QVERIFY(lensGrid(lensOf({-0.1, 0, 0, 0, 0})).fold.empty());
  }

  /// The image shows at p what a pinhole sees at model(p), so model(p) lies on the grid.
  void directMapping() {
    const DistortionParams lens{0.3, 0.1, 0.01, -0.02, 0};
    const LensGrid grid = lensGrid(lensOf(lens, LensMapping::direct));
    QVERIFY(grid.fold.empty());
    QVERIFY(!grid.lines.empty());
    for (const std::vector<Vec2>& line : grid.lines)
      for (const Vec2& point : line) {
        const Vec2 world = Distortion(lens).distort({(point.x - 310) / 500, (point.y - 250) / 520});
        QVERIFY(std::min(missOf(world.x), missOf(world.y)) < 1e-9);
      }
  }

  void anExtremeLensIsDrawnAtOnce() {
    for (const double k : {-10.0, 10.0})
      for (const LensMapping mapping : {LensMapping::exact, LensMapping::direct}) {
        const LensGrid grid = lensGrid(lensOf({k, k, k, k, k}, mapping));
        QVERIFY(grid.lines.size() < 2000);
        for (const std::vector<Vec2>& line : grid.lines) QVERIFY(line.size() >= 2);
      }
  }
};

QTEST_APPLESS_MAIN(TestLensGrid)
#include "test_lens_grid.moc"
