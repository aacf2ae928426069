// SPDX-License-Identifier: BSD-3-Clause
// Whether content fits a display in depth: against closed forms, and against brute force.
#include "core/panel/depth_budget.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/panel/design_numbers.h"

using namespace hogelscope;

namespace {

bool isNear(double a, double b, double relative = 1e-9) {
  return a == b || std::abs(a - b) <= relative * std::abs(b);
}

/// The paper's display.
PanelParams paperDisplay() {
  PanelParams display;
  display.hogels = {512, 512};
  display.directions = {600, 600};
  return display;
}

constexpr double distance = 0.559;

}  // namespace

class TestDepthBudget : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void dioptresAndDepths() {
    for (const double z : {-100.0, -0.3, 0.0, 0.2, 0.558})
      QVERIFY(isNear(depthAt(dioptresAt(z, distance), distance), z, 1e-6));
    QCOMPARE(depthAt(-1 / distance, distance), -std::numeric_limits<double>::infinity());
    QCOMPARE(depthAt(-3, distance), -std::numeric_limits<double>::infinity());
  }

  void limitsOfThePapersDisplay() {
    const DepthLimits limits = depthLimits(paperDisplay(), distance, {});
    const DepthRange sharp = limits.inMetres(limits.display);
    QVERIFY(isNear(sharp.front, 0.266, 2e-3));
    QVERIFY(isNear(sharp.behind, 5.50, 2e-3));
    QVERIFY(isNear(limits.display, 1.624, 1e-3));
    QVERIFY(isNear(limits.comfort, 0.277, 1e-3));
    QCOMPARE(limits.both(), limits.comfort);
    // In front and behind as the design numbers have them.
    const DesignNumbers numbers = designNumbers(paperDisplay(), {0, 0, distance});
    QVERIFY(isNear(sharp.front, numbers.depthFront));
    QVERIFY(isNear(sharp.behind, numbers.depthBehind));
    QVERIFY(isNear(limits.disparityOf(limits.display), -1));
    QVERIFY(isNear(limits.directionsPerPupil, 3.72, 2e-3));
    QCOMPARE(limits.mismatchOf(-0.5), 0.0);  // 3.7 directions enter a pupil
  }

  void limitsOfOneAxis() {
    PanelParams display = paperDisplay();
    display.directions = {600, 1};
    QVERIFY(isNear(depthLimits(display, distance, {}).display, 1.624, 1e-3));
    display.directions = {1, 1};
    const DepthLimits none = depthLimits(display, distance, {});
    QVERIFY(std::isinf(none.display));
    QCOMPARE(none.disparityOf(0), 0.0);
    display.directions = {20, 20};
    QCOMPARE(depthLimits(display, distance, {}).mismatchOf(-0.5), 0.5);
  }

  /// A point's shift over the panel, as the eye sees it, by similar triangles alone.
  void disparityOfAPoint() {
    const PanelParams panel = paperDisplay();
    const Display display(panel);
    const DepthLimits limits = depthLimits(panel, distance, {});
    const double pitch = panel.size[0] / panel.hogels[0];
    for (const double z : {-1.0, -0.1, 0.05, 0.3}) {
      const double slope = display.slopes(301, 300).x - display.slopes(300, 300).x;
      const double atDepth = -z * slope;                           // on the point's own plane
      const double onPanel = atDepth * distance / (distance - z);  // along the eye's rays
      QVERIFY(isNear(limits.disparityOf(dioptresAt(z, distance)), onPanel / pitch, 1e-4));
    }
  }

  void shortestIntervals() {
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    for (const std::size_t count : {1, 2, 7, 20, 151}) {
      std::vector<double> values(count);
      for (double& value : values) value = normal(random);
      std::ranges::sort(values);
      for (const double share : {0.01, 0.5, 0.95, 1.0}) {
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < count; ++i)
          for (std::size_t k = i; k < count; ++k)
            if (double(k - i + 1) >= share * double(count) - 1e-9)
              best = std::min(best, values[k] - values[i]);
        const auto [low, high] = shortestInterval(values, share);
        QCOMPARE(high - low, best);
      }
    }
  }

  void fits() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int k = 0; k < 1000; ++k) {
      const double back = uniform(random) - 0.7;
      const double front = back + uniform(random);
      const double behind = 0.3 * uniform(random) + 0.01;
      const double before = 0.3 * uniform(random) + 0.01;
      const DepthFit fit = fitDepths(back, front, behind, before);
      const double low = fit.scale * (back - fit.zero);
      const double high = fit.scale * (front - fit.zero);
      QVERIFY(low >= -behind - 1e-12 && high <= before + 1e-12);
      QVERIFY(fit.scale <= 1);
      if (fit.scale < 1) {  // all of the room is used
        QVERIFY(isNear(low, -behind) && isNear(high, before));
      } else if (fit.zero != 0) {  // no smaller shift is enough
        const double less = 0.999 * fit.zero;
        QVERIFY(back - less < -behind || front - less > before);
      }
    }
    const double infinite = std::numeric_limits<double>::infinity();
    QCOMPARE(fitDepths(-100, -1, infinite, 0.2).zero, 0.0);
    QCOMPARE(fitDepths(-100, 1, infinite, 0.2).zero, 0.8);
    QCOMPARE(fitDepths(-100, 1, infinite, 0.2).scale, 1.0);
  }

  /// In dioptres the zero point is DisplayXR's g*, the harmonic mean of near and far.
  void zeroPointOfAScene() {
    const double near = 0.4;
    const double far = 3;
    const double before = 0.3;
    const double behind = 0.2;
    const DepthFit fit = fitDepths(1 / far - 1 / distance, 1 / near - 1 / distance, behind, before);
    const double plane = (before + behind) / (behind / near + before / far);
    QVERIFY(isNear(1 / (1 / distance + fit.zero), plane));
  }
};

QTEST_GUILESS_MAIN(TestDepthBudget)
#include "test_depth_budget.moc"
