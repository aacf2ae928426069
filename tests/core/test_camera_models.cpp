// SPDX-License-Identifier: BSD-3-Clause
// The rational and the fisheye lens: against OpenCV, closed forms and slow walks.
#include <QTest>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/calib3d.hpp>

#include "core/base/error.h"
#include "core/cameras/camera_path.h"
#include "core/lens/batch_undistort.h"
#include "core/lens/lens_certificate.h"
#include "core/optics/distortion.h"
#include "tests/core/lens_oracle.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

constexpr double focal = 520;
constexpr double turn = 2 * std::numbers::pi;

/// Sizes of coefficients: those of usual lenses, then up to all that documents may have.
double randomLimit(Random& random) {
  return random.flip() ? 1 : std::pow(10, random.uniform(-1, 3));
}

DistortionParams randomRational(Random& random, double limit, bool isRound) {
  DistortionParams p;
  p.model = DistortionModel::rational;
  for (const LensCoefficient& k : coefficientsOf(p.model))
    p.*k.value = random.uniform(-limit, limit);
  if (isRound) p.p1 = p.p2 = 0;
  p.p1 = std::clamp(p.p1, -1.0, 1.0);
  p.p2 = std::clamp(p.p2, -1.0, 1.0);
  return p;
}

DistortionParams randomFisheye(Random& random, double limit) {
  DistortionParams p;
  p.model = DistortionModel::fisheye;
  for (const LensCoefficient& k : coefficientsOf(p.model))
    p.*k.value = random.uniform(-limit, limit);
  return p;
}

LensOracle oracleOf(const DistortionParams& p) {
  return {p.k1, p.k2, p.p1, p.p2, p.k3, p.k4, p.k5, p.k6};
}

/// Where r_d of a round rational lens stops growing: at a fold, or behind a pole. `end` if it does
/// not before. Looks at 200 000 places.
struct RadialEnd {
  double radius;
  double distorted;
  bool isFold;
};

RadialEnd radialEnd(const DistortionParams& p, double end) {
  constexpr int places = 200000;
  const LensOracle lens = oracleOf(p);
  RadialEnd at{0, 0, false};
  for (int k = 1; k <= places; ++k) {
    const double r = end * k / places;
    const double s = r * r;
    const double divisor = 1 + s * (p.k4 + s * (p.k5 + s * p.k6));
    if (!(divisor > 0)) return at;  // a pole: r_d had grown without end, or it folded before
    const double distorted = lens.distort(r).real();
    if (!(distorted > at.distorted)) return {at.radius, at.distorted, true};
    at = {r, distorted, false};
  }
  return at;
}

/// θ_d of a fisheye, and the angle at which it stops growing, at most 90°.
struct SlowFisheye {
  std::array<double, 4> k;
  [[nodiscard]] double distorted(double angle) const {
    return angle + k[0] * std::pow(angle, 3) + k[1] * std::pow(angle, 5) +
           k[2] * std::pow(angle, 7) + k[3] * std::pow(angle, 9);
  }
  [[nodiscard]] double end() const {
    constexpr int places = 400000;
    double before = 0;
    for (int n = 1; n <= places; ++n) {
      const double angle = std::numbers::pi / 2 * n / places;
      if (!(distorted(angle) > before)) return std::numbers::pi / 2 * (n - 1) / places;
      before = distorted(angle);
    }
    return std::numbers::pi / 2;
  }
};

Vec2 polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

double length(const Vec2& p) {
  return std::hypot(p.x, p.y);
}

double residual(const Distortion& lens, const Vec2& ideal, const Vec2& distorted) {
  const Vec2 back = lens.distort(ideal);
  return focal * std::hypot(back.x - distorted.x, back.y - distorted.y);
}

/// Compares the inverse of many points with that of each.
QString firstDifference(const DistortionParams& params, double size, Random& random) {
  const Distortion lens(params);
  const BatchUndistort quick(lens);
  constexpr int count = 150;
  std::array<double, count> x, y;
  for (int k = 0; k < count; ++k) {
    x[std::size_t(k)] = random.uniform(-size, size);
    y[std::size_t(k)] = random.uniform(-size, size);
  }
  std::array<double, count> idealX = x, idealY = y;
  quick.undistort(idealX.data(), idealY.data(), count);
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 q{x[k], y[k]};
    const auto certain = lens.undistort(q);
    if (certain.has_value() == std::isnan(idealX[k]))
      return QString("(%1, %2): a ray %3").arg(q.x).arg(q.y).arg(certain.has_value());
    if (certain && !(residual(lens, {idealX[k], idealY[k]}, q) < 1e-9 * (1 + length(q))))
      return QString("(%1, %2): residual %3")
          .arg(q.x)
          .arg(q.y)
          .arg(residual(lens, {idealX[k], idealY[k]}, q));
  }
  return {};
}

QString described(const DistortionParams& p) {
  QString text;
  for (const LensCoefficient& k : coefficientsOf(p.model))
    text += QString("%1 %2 ").arg(k.name).arg(p.*k.value, 0, 'g', 17);
  return text;
}

}  // namespace

class TestCameraModels : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void formulasAreOpenCvs();
  void jacobiansAreThoseOfTheFormulas();
  void boundsHoldInTheirRings();
  void derivativeBoundsHold();
  void rationalWithoutDivisorIsBrowns();
  void rationalAgreesWithTheWalk();
  void roundRationalEndsAtItsFoldOrPole();
  void fisheyeEndsAtItsFoldOrAt90Degrees();
  void manyPointsAreAsEach();
  void openCvGivesThePixelsOfTheRays();
  void otherModelsCoefficientsAreRefused();
  void aChangeOfModelKeepsWhatItCan();
  void noLensIsBetweenAFisheyeAndAnother();
};

void TestCameraModels::formulasAreOpenCvs() {
  Random random(1);
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const bool isFisheye = repeat % 2 == 0;
    const DistortionParams p =
        isFisheye ? randomFisheye(random, 0.3) : randomRational(random, 1, false);
    const std::vector<double> k = vectorOf(p);
    QCOMPARE(k.size(), isFisheye ? 4U : 8U);
    const Vec2 ideal{random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8)};
    const std::vector<cv::Point3d> point{{ideal.x, ideal.y, 1}};
    std::vector<cv::Point2d> theirs;
    const cv::Vec3d none(0, 0, 0);
    if (isFisheye)
      cv::fisheye::projectPoints(point, theirs, none, none, cv::Matx33d::eye(), k);
    else
      cv::projectPoints(point, none, none, cv::Matx33d::eye(), k, theirs);
    const Vec2 ours = Distortion(p).distort(ideal);
    QVERIFY(std::abs(ours.x - theirs[0].x) + std::abs(ours.y - theirs[0].y) <
            1e-12 * (1 + length(ours)));
  }
}

void TestCameraModels::jacobiansAreThoseOfTheFormulas() {
  Random random(2);
  constexpr double h = 1e-6;
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const Distortion lens(repeat % 2 == 0 ? randomFisheye(random, 0.3)
                                          : randomRational(random, 0.3, false));
    const Vec2 p{random.uniform(-1, 1), random.uniform(-1, 1)};
    const Vec2 right = lens.distort({p.x + h, p.y}), left = lens.distort({p.x - h, p.y});
    const Vec2 up = lens.distort({p.x, p.y + h}), down = lens.distort({p.x, p.y - h});
    const Jacobian j = lens.jacobian(p);
    const double size = 1 + std::abs(j.xx) + std::abs(j.yy) + std::abs(j.xy);
    if (size > 30) continue;  // a pole is near
    QVERIFY(std::abs((right.x - left.x) / (2 * h) - j.xx) < 1e-6 * size * size);
    QVERIFY(std::abs((up.x - down.x) / (2 * h) - j.xy) < 1e-6 * size * size);
    QVERIFY(std::abs((right.y - left.y) / (2 * h) - j.yx) < 1e-6 * size * size);
    QVERIFY(std::abs((up.y - down.y) / (2 * h) - j.yy) < 1e-6 * size * size);
  }
}

void TestCameraModels::boundsHoldInTheirRings() {
  Random random(3);
  int finite = 0;
  for (int repeat = 0; repeat < 20000; ++repeat) {
    const Distortion lens(randomRational(random, randomLimit(random), false));
    const double from = std::pow(10, random.uniform(-2, 1));
    const double step = from * std::pow(10, random.uniform(-6, -0.5));
    const RadialBounds bounds = lens.radialBounds(from, step);
    if (!std::isfinite(bounds.slopeBend)) continue;
    ++finite;
    double r0 = from;
    for (int k = 1; k <= 8; ++k) {
      const double r1 = from + step * k / 8;
      const RadialTerms a = lens.radial(r0), b = lens.radial(r1);
      const double slack = 1 + 1e-6;
      const double rounding = 1e3 * bounds.rounding / from;
      QVERIFY(std::abs(b.slopeChange - a.slopeChange) <=
              slack * bounds.slopeBend * (r1 - r0) + rounding);
      QVERIFY(std::abs(b.acrossChange - a.acrossChange) <=
              slack * bounds.acrossBend * (r1 - r0) + rounding);
      r0 = r1;
    }
  }
  QVERIFY2(finite > 10000, qPrintable(QString::number(finite)));
}

void TestCameraModels::derivativeBoundsHold() {
  Random random(4);
  int finite = 0;
  for (int repeat = 0; repeat < 20000; ++repeat) {
    const Distortion lens(randomRational(random, randomLimit(random), false));
    const double radius = std::pow(10, random.uniform(-2, 1));
    const double within = radius * std::pow(10, random.uniform(-5, -0.3));
    const DerivativeBounds bounds = lens.derivativeBounds(radius, within);
    if (!(bounds.second < 1e12)) continue;
    ++finite;
    const double angle = random.uniform(0, turn);
    const Vec2 middle = polar(radius, angle);
    const Vec2 away = polar(random.uniform(0.1, 1) * within, random.uniform(0, turn));
    const Jacobian a = lens.jacobian(middle);
    const Jacobian b = lens.jacobian({middle.x + away.x, middle.y + away.y});
    // The change of the Jacobian is at most the bound of its derivative over the way.
    const double mean = (b.xx - a.xx + b.yy - a.yy) / 2;
    const double spread = std::hypot((b.xx - a.xx - b.yy + a.yy) / 2, b.xy - a.xy);
    const double change = std::abs(mean) + spread;
    QVERIFY2(change <= (1 + 1e-6) * bounds.second * length(away) + 1e-9 * (std::abs(a.xx) + 1),
             qPrintable(described(lens.params())));
  }
  QVERIFY2(finite > 10000, qPrintable(QString::number(finite)));
}

void TestCameraModels::rationalWithoutDivisorIsBrowns() {
  Random random(5);
  for (int repeat = 0; repeat < 500; ++repeat) {
    DistortionParams p = randomRational(random, 1, false);
    p.k4 = p.k5 = p.k6 = 0;
    DistortionParams browns = p;
    browns.model = DistortionModel::brown;
    const Vec2 q{random.uniform(-1, 1), random.uniform(-1, 1)};
    QVERIFY(Distortion(p).distort(q) == Distortion(browns).distort(q));
    QVERIFY(Distortion(p).undistort(q) == Distortion(browns).undistort(q));
    Vec2 ours = q, theirs = q;
    BatchUndistort(Distortion(p)).undistort(&ours.x, &ours.y, 1);
    BatchUndistort(Distortion(browns)).undistort(&theirs.x, &theirs.y, 1);
    QVERIFY(ours == theirs || (std::isnan(ours.x) && std::isnan(theirs.x)));
  }
}

void TestCameraModels::rationalAgreesWithTheWalk() {
  Random random(6);
  std::array<int, 3> ends{};
  for (int repeat = 0; repeat < 3000; ++repeat) {
    const DistortionParams p = randomRational(random, randomLimit(random), false);
    const Vec2 q{random.uniform(-1, 1), random.uniform(-1, 1)};
    const auto walk = oracleOf(p).walk({q.x, q.y});
    ++ends[std::size_t(walk.end)];
    if (walk.end == LensOracle::Walk::End::unclear) continue;
    const Distortion lens(p);
    const auto ideal = lens.undistort(q);
    QVERIFY2(ideal.has_value() == (walk.end == LensOracle::Walk::End::ray),
             qPrintable(described(p) + QString(" q %1 %2").arg(q.x).arg(q.y)));
    if (!ideal) continue;
    QVERIFY(std::abs(LensOracle::Point(ideal->x, ideal->y) - walk.point) < 1e-6);
    QVERIFY(residual(lens, *ideal, q) < 1e-9);
  }
  QVERIFY2(ends[0] > 800 && ends[1] > 800 && ends[2] < 400,
           qPrintable(QString("%1 %2 %3").arg(ends[0]).arg(ends[1]).arg(ends[2])));
}

void TestCameraModels::roundRationalEndsAtItsFoldOrPole() {
  Random random(7);
  int folds = 0;
  int poles = 0;
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const DistortionParams p = randomRational(random, randomLimit(random), true);
    const RadialEnd end = radialEnd(p, 10);
    if (!(end.distorted > 0)) continue;
    const Distortion lens(p);
    const double angle = random.uniform(0, turn);
    const Vec2 q = polar(std::min(0.999 * end.distorted, 0.999 * Distortion::farthest), angle);
    const auto inside = lens.undistort(q);
    QVERIFY2(inside, qPrintable(described(p)));
    QVERIFY(length(*inside) <= end.radius);
    const Vec2 far = polar(1.001 * std::max(end.distorted, Distortion::farthest), angle);
    QVERIFY2(!lens.undistort(far), qPrintable(described(p)));
    Vec2 together = far;
    BatchUndistort(lens).undistort(&together.x, &together.y, 1);
    QVERIFY2(std::isnan(together.x), qPrintable(described(p)));
    // Before a pole rounding of the radius alone moves the pixel.
    const Jacobian j = lens.jacobian(*inside);
    const double rounding = 1e-13 * (std::abs(j.xx) + std::abs(j.yy)) * length(*inside);
    QVERIFY(residual(lens, *inside, q) < 1e-9 * (1 + length(q)) + rounding);
    if (end.isFold) {
      ++folds;
      QVERIFY2(!lens.undistort(polar(1.001 * end.distorted, angle)), qPrintable(described(p)));
    } else if (end.radius < 9.99) {
      ++poles;
    }
  }
  QVERIFY2(folds > 500 && poles > 200, qPrintable(QString("%1 %2").arg(folds).arg(poles)));
}

void TestCameraModels::fisheyeEndsAtItsFoldOrAt90Degrees() {
  Random random(8);
  int folds = 0;
  int whole = 0;
  for (int repeat = 0; repeat < 250; ++repeat) {
    const DistortionParams p = randomFisheye(random, randomLimit(random) * 0.3);
    const SlowFisheye slow{{p.k1, p.k2, p.k3, p.k4}};
    const double end = slow.end();
    const Distortion lens(p);
    const double angle = random.uniform(0, turn);
    for (const double share : {random.uniform(0, 1), 0.9999}) {
      const double theta = share * end;
      const auto inside = lens.undistort(polar(slow.distorted(theta), angle));
      QVERIFY2(inside, qPrintable(described(p)));
      const Vec2 q = polar(slow.distorted(theta), angle);
      QVERIFY(residual(lens, *inside, q) < 1e-9 * (1 + length(q)));
      // Near a fold the distance tells the angle badly.
      if (share < 0.9) QVERIFY(std::abs(std::atan(length(*inside)) - theta) < 1e-9);
      QVERIFY(std::abs(std::atan2(inside->y, inside->x) -
                       std::atan2(std::sin(angle), std::cos(angle))) < 1e-12);
    }
    ++(end < 1.57 ? folds : whole);
    QVERIFY(!lens.undistort(polar(1.0001 * slow.distorted(end) + 1e-9, angle)));
    const double valid = validRadius(lens);
    QVERIFY(end < 1.57 ? std::abs(std::atan(valid) - end) < 1e-4 : valid > 1000);
  }
  QVERIFY2(folds > 50 && whole > 50, qPrintable(QString("%1 %2").arg(folds).arg(whole)));
}

void TestCameraModels::manyPointsAreAsEach() {
  Random random(9);
  for (int repeat = 0; repeat < 120; ++repeat) {
    const double limit = randomLimit(random);
    const DistortionParams p = repeat % 3 == 0   ? randomFisheye(random, limit)
                               : repeat % 3 == 1 ? randomRational(random, limit, true)
                                                 : randomRational(random, limit, false);
    const QString difference = firstDifference(p, repeat % 2 == 0 ? 1 : 3, random);
    QVERIFY2(difference.isEmpty(), qPrintable(described(p) + difference));
  }
}

/// Rays of 170° too.
void TestCameraModels::openCvGivesThePixelsOfTheRays() {
  Random random(10);
  const cv::Matx33d camera(focal, 0, 0, 0, focal, 0, 0, 0, 1);
  const cv::Vec3d none(0, 0, 0);
  int rays = 0;
  for (int repeat = 0; repeat < 4000; ++repeat) {
    const bool isFisheye = repeat % 2 == 0;
    const DistortionParams p =
        isFisheye ? randomFisheye(random, 0.1) : randomRational(random, 1, false);
    const Vec2 q = polar(random.uniform(0, isFisheye ? 1.48 : 0.8), random.uniform(0, turn));
    const auto ideal = Distortion(p).undistort(q);
    if (!ideal) continue;
    ++rays;
    std::vector<cv::Point2d> theirs;
    const std::vector<cv::Point3d> point{{ideal->x, ideal->y, 1}};
    if (isFisheye)
      cv::fisheye::projectPoints(point, theirs, none, none, camera, vectorOf(p));
    else
      cv::projectPoints(point, none, none, camera, vectorOf(p), theirs);
    QVERIFY(std::hypot(theirs[0].x - focal * q.x, theirs[0].y - focal * q.y) < 1e-6);
  }
  QVERIFY2(rays > 2500, qPrintable(QString::number(rays)));
}

void TestCameraModels::otherModelsCoefficientsAreRefused() {
  DistortionParams p;
  p.k4 = 0.1;
  QVERIFY_THROWS_EXCEPTION(InputError, check(p));
  p.model = DistortionModel::rational;
  check(p);
  p.model = DistortionModel::fisheye;
  check(p);
  QVERIFY(!DistortionParams{.model = DistortionModel::fisheye}.isPinhole());
  p.p1 = 0.1;
  QVERIFY_THROWS_EXCEPTION(InputError, check(p));
}

void TestCameraModels::aChangeOfModelKeepsWhatItCan() {
  const DistortionParams all{50, -20, 3, 4, 5, 6, 7, 8, DistortionModel::rational};
  DistortionParams p = all;
  p.model = DistortionModel::fisheye;
  QVERIFY((ofItsModel(p) == DistortionParams{50, -20, 0, 0, 5, 6, 0, 0, DistortionModel::fisheye}));
  p.model = DistortionModel::brown;
  QVERIFY((ofItsModel(p) == DistortionParams{10, -10, 3, 4, 5}));
  QVERIFY(ofItsModel(all) == all);
}

void TestCameraModels::noLensIsBetweenAFisheyeAndAnother() {
  std::vector<CameraState> states(2);
  states[0].distortion.k1 = 0.2;
  states[1].distortion = {0.4, 0, 0, 0, 0, 0.1, 0, 0, DistortionModel::rational};
  const DistortionParams half{0.3, 0, 0, 0, 0, 0.05, 0, 0, DistortionModel::rational};
  const DistortionParams mixed = stateAt(states, 0.5).distortion;
  QVERIFY(mixed.model == half.model && std::abs(mixed.k1 - half.k1) < 1e-15 && mixed.k4 == half.k4);
  states[1].distortion.model = DistortionModel::fisheye;
  QVERIFY_THROWS_EXCEPTION(InputError, (void)stateAt(states, 0.5));
}

QTEST_APPLESS_MAIN(TestCameraModels)
#include "test_camera_models.moc"
