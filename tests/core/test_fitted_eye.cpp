// SPDX-License-Identifier: BSD-3-Clause
// The eye that points fill the image of: all are in it, and some touch two opposite edges.
#include <QtTest>
#include <random>

#include "core/optics/scene_eyes.h"

using namespace hogelscope;

class TestFittedEye : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pointsTouchTheEdges() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> sides(-1, 1);
    const auto any = [&] { return sides(random); };
    int filling = 0;
    for (int k = 0; k < 200; ++k) {
      const RigidTransform frame = transformFromPose({}, {90 * any(), 90 * any(), 90 * any()});
      const Vec2 tangents{1.1 + any(), 1.1 + any()};
      std::vector<Vec3> points(20);
      for (Vec3& point : points) point = {3 + any(), any(), any()};
      const auto [eye, target] = fittedEye(points, frame, tangents);
      QVERIFY(length(cross(eye - target, frame.zAxis)) < 1e-9);
      QVERIFY(dot(eye - target, frame.zAxis) > 0);
      double nearest = HUGE_VAL;
      double farthest = 0;
      double left = 1;
      double right = -1;
      double low = 1;
      double high = -1;
      for (const Vec3& point : points) {
        const double depth = dot(eye - point, frame.zAxis);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
        const double x = dot(point - eye, frame.xAxis) / depth / tangents.x;
        const double y = dot(point - eye, frame.yAxis) / depth / tangents.y;
        left = std::min(left, x);
        right = std::max(right, x);
        low = std::min(low, y);
        high = std::max(high, y);
      }
      const double wide = std::max(std::abs(left), std::abs(right));
      const double tall = std::max(std::abs(low), std::abs(high));
      QVERIFY(wide <= 1 + 1e-9 && tall <= 1 + 1e-9);
      const bool fillsWidth = std::abs(left + 1) < 1e-9 && std::abs(right - 1) < 1e-9;
      const bool fillsHeight = std::abs(low + 1) < 1e-9 && std::abs(high - 1) < 1e-9;
      const bool isNearest = std::abs(farthest - 3 * nearest) < 1e-9;
      QVERIFY(fillsWidth || fillsHeight || isNearest);
      filling += fillsWidth || fillsHeight ? 1 : 0;
    }
    QVERIFY2(filling > 50 && filling < 200, qPrintable(QString::number(filling)));
  }

  /// Of a box that is twice as wide as high, in its own frame.
  void aParallelViewTouchesTheEdges() {
    const RigidTransform frame = transformFromPose({}, {30, 20, 10});
    const Vec3 middle{1, 2, 3};
    std::vector<Vec3> points;
    for (const double x : {-2, 2})
      for (const double y : {-1, 1})
        for (const double z : {-3, 3}) points.push_back(frame.direction(middle + Vec3{x, y, z}));
    for (const auto& [aspect, halfHeight] : {std::pair(2.0, 1.0), std::pair(1.0, 2.0)}) {
      const ParallelView view = fittedParallel(points, frame, aspect);
      QVERIFY(length(view.target - frame.direction(middle)) < 1e-12);
      QVERIFY(std::abs(view.halfHeight - halfHeight) < 1e-12);
    }
  }

  /// What has not been dragged keeps all its digits.
  void draggedPlacesAreRounded() {
    const Vec3 before{0.123456, 0.2, 0.3};
    QVERIFY(rounded({0.123456, 0.34567, -0.00089}, before, 0.004) ==
            Vec3({0.123456, 0.346, -0.001}));
    QVERIFY(rounded({7, 8, 123.4}, before, 30) == Vec3({10, 10, 120}));
  }
};

QTEST_APPLESS_MAIN(TestFittedEye)
#include "test_fitted_eye.moc"
