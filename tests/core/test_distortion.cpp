// SPDX-License-Identifier: BSD-3-Clause
// Tests the lens model against OpenCV's, and its inverse where other methods fail
// (docs/formulas.md, Known failures).
#include <QTest>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "core/optics/distortion.h"
#include "tests/core/lens_oracle.h"
#include "tests/core/random.h"

using namespace hogelscope;

Q_DECLARE_METATYPE(hogelscope::DistortionParams)

namespace {

/// The paper's and the table's cameras: f of 60° over 600 rows.
const double focal = 300 * std::sqrt(3.0);

cv::Vec<double, 5> openCvs(const DistortionParams& p) {
  return {p.k1, p.k2, p.p1, p.p2, p.k3};
}

cv::Point2d openCvDistorts(const DistortionParams& lens, const Vec2& p) {
  std::vector<cv::Point2d> image;
  cv::projectPoints(std::vector{cv::Point3d(p.x, p.y, 1)}, cv::Vec3d::all(0), cv::Vec3d::all(0),
                    cv::Matx33d::eye(), openCvs(lens), image);
  return image.front();
}

cv::Point2d openCvUndistorts(const DistortionParams& lens, const Vec2& q, int iterations) {
  std::vector<cv::Point2d> ideal;
  const std::vector distorted{cv::Point2d(q.x, q.y)};
  const cv::TermCriteria criteria(cv::TermCriteria::COUNT, iterations, 0);
  cv::undistortPoints(distorted, ideal, cv::Matx33d::eye(), openCvs(lens), cv::noArray(),
                      cv::noArray(), criteria);
  return ideal.front();
}

/// How far `ideal` is from being the preimage of q, in pixels.
double residual(const DistortionParams& lens, const Vec2& ideal, const Vec2& q) {
  const cv::Point2d d = openCvDistorts(lens, ideal);
  return focal * std::hypot(d.x - q.x, d.y - q.y);
}

/// 41×41 points over the whole image.
std::vector<Vec2> gridOf41() {
  std::vector<Vec2> points(std::size_t{41} * 41);
  const auto coordinate = [](std::size_t k) { return (double(k) * 599 / 40 - 299.5) / focal; };
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = {coordinate(k % 41), coordinate(k / 41)};
  return points;
}

DistortionParams randomLens(Random& random) {
  const auto k = [&random] { return random.uniform(-1, 1); };
  return {k(), k(), k(), k(), k()};
}

}  // namespace

class TestDistortion : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void distortIsOpenCvs();
  void jacobianIsTheDerivative();
  void identity();
  void papersLenses_data();
  void papersLenses();
  void openCvsFiveIterationsMissThePapersLenses_data() { papersLenses_data(); }
  void openCvsFiveIterationsMissThePapersLenses();
  void rightRootWhereTheFixedPointSettlesElsewhere();
  void convergesWhereTheFixedPointDiverges();
  void noRayBeyondTheFold();
};

void TestDistortion::distortIsOpenCvs() {
  Random random(1);
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const DistortionParams lens = randomLens(random);
    const Vec2 p{random.uniform(-2, 2), random.uniform(-2, 2)};
    const Vec2 ours = Distortion(lens).distort(p);
    const cv::Point2d theirs = openCvDistorts(lens, p);
    // Relative to the largest term, because they may cancel.
    const double r = std::hypot(p.x, p.y);
    const double scale = r + std::pow(r, 3) + std::pow(r, 5) + std::pow(r, 7) + 6 * r * r;
    QVERIFY(std::hypot(ours.x - theirs.x, ours.y - theirs.y) < 1e-12 * scale);
  }
}

void TestDistortion::jacobianIsTheDerivative() {
  Random random(2);
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const Distortion lens(randomLens(random));
    const Vec2 p{random.uniform(-1, 1), random.uniform(-1, 1)};
    constexpr double h = 1e-4;
    const Vec2 left = lens.distort({p.x - h, p.y});
    const Vec2 right = lens.distort({p.x + h, p.y});
    const Vec2 above = lens.distort({p.x, p.y - h});
    const Vec2 below = lens.distort({p.x, p.y + h});
    const Jacobian j = lens.jacobian(p);
    constexpr double tolerance = 1e-5;  // h² times a third derivative, at most a few hundred
    QVERIFY(std::abs((right.x - left.x) / (2 * h) - j.xx) < tolerance);
    QVERIFY(std::abs((below.x - above.x) / (2 * h) - j.xy) < tolerance);
    QVERIFY(std::abs((right.y - left.y) / (2 * h) - j.yx) < tolerance);
    QVERIFY(std::abs((below.y - above.y) / (2 * h) - j.yy) < tolerance);
  }
}

void TestDistortion::identity() {
  const Distortion none({});
  QVERIFY(none.isIdentity());
  QVERIFY(*none.undistort({0.3, -7}) == (Vec2{0.3, -7}));
  for (int k = 0; k < 5; ++k) {
    DistortionParams lens;
    *std::array{&lens.k1, &lens.k2, &lens.p1, &lens.p2, &lens.k3}[std::size_t(k)] = 1e-9;
    QVERIFY(!Distortion(lens).isIdentity());
    QVERIFY(*Distortion(lens).undistort({0.3, -0.7}) != (Vec2{0.3, -0.7}));
  }
}

void TestDistortion::papersLenses_data() {
  QTest::addColumn<DistortionParams>("lens");
  QTest::newRow("Fig. 1") << DistortionParams{0.6, 0.4, 0, 0, 0.3};
  QTest::newRow("Fig. 2") << DistortionParams{0, 0, 0.2, 0.1, 0};
  QTest::newRow("Fig. 3") << DistortionParams{0.6, 0.3, 0.2, 0.01, 0.2};
}

void TestDistortion::papersLenses() {
  QFETCH(const DistortionParams, lens);
  const LensOracle oracle(lens.k1, lens.k2, lens.p1, lens.p2, lens.k3);
  for (const Vec2& q : gridOf41()) {
    const auto ideal = Distortion(lens).undistort(q);
    const auto walk = oracle.walk({q.x, q.y});
    QCOMPARE(ideal.has_value(), walk.end == LensOracle::Walk::End::ray);
    if (!ideal) continue;
    QVERIFY(residual(lens, *ideal, q) < 1e-9);
    QVERIFY(std::abs(LensOracle::Point(ideal->x, ideal->y) - walk.point) < 1e-6);
  }
}

/// Shows that papersLenses is no easy test.
void TestDistortion::openCvsFiveIterationsMissThePapersLenses() {
  QFETCH(const DistortionParams, lens);
  double worst = 0;
  for (const Vec2& q : gridOf41()) {
    if (!Distortion(lens).undistort(q)) continue;
    const cv::Point2d theirs = openCvUndistorts(lens, q, 5);
    worst = std::max(worst, residual(lens, {theirs.x, theirs.y}, q));
  }
  QVERIFY2(worst > 1, qPrintable(QString::number(worst)));
}

void TestDistortion::rightRootWhereTheFixedPointSettlesElsewhere() {
  const DistortionParams lens{-0.45, 0.25, 0, 0, 0};
  const double root = 1.2498;
  // The corner, 4:3, of the camera whose inverse there is `root`.
  const double rd = root * (1 - 0.45 * std::pow(root, 2) + 0.25 * std::pow(root, 4));
  const Vec2 corner{0.8 * rd, 0.6 * rd};
  const auto ideal = Distortion(lens).undistort(corner);
  QVERIFY(ideal);
  QVERIFY(std::hypot(ideal->x - 0.8 * root, ideal->y - 0.6 * root) < 1e-12);
  const cv::Point2d theirs = openCvUndistorts(lens, corner, 1001);
  QVERIFY(residual(lens, {theirs.x, theirs.y}, corner) > 100);
}

void TestDistortion::convergesWhereTheFixedPointDiverges() {
  const DistortionParams lens{0.5, 0, 0, 0, 0};
  const Vec2 q{1.8, -2.4};  // r_d = 3
  const auto ideal = Distortion(lens).undistort(q);
  QVERIFY(ideal);
  QVERIFY(residual(lens, *ideal, q) < 1e-9);
  const auto theirResidual = [&](int iterations) {
    const cv::Point2d p = openCvUndistorts(lens, q, iterations);
    return residual(lens, {p.x, p.y}, q);
  };
  QVERIFY(theirResidual(5) > 1);
  QVERIFY(theirResidual(200) > theirResidual(5));
}

void TestDistortion::noRayBeyondTheFold() {
  // OpenCV's samples/data/intrinsics.yml.
  const double k1 = 0.2958943955272433;
  const double k2 = -1.0354662043042675;
  const Distortion lens({k1, k2, 0, 0, 0});
  // r_d stops growing where 1 + 3 k1 r² + 5 k2 r⁴ = 0.
  const double fold = std::sqrt((3 * k1 + std::sqrt(9 * k1 * k1 - 20 * k2)) / (-10 * k2));
  QVERIFY(std::abs(fold - 0.7304) < 1e-4);
  const double largest = lens.distort({fold, 0}).x;
  QVERIFY(std::abs(largest - 0.630) < 1e-3);
  const auto ray = [&](double rd) { return lens.undistort({0.8 * rd, -0.6 * rd}); };
  QVERIFY(!ray(0.772));  // the corner
  QVERIFY(!ray(largest + 1e-9));
  const auto inside = ray(largest - 1e-9);
  QVERIFY(inside && std::hypot(inside->x, inside->y) < fold);
}

QTEST_APPLESS_MAIN(TestDistortion)
#include "test_distortion.moc"
