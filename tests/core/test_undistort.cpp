// SPDX-License-Identifier: BSD-3-Clause
// Tests the lens's inverse on random lenses: against closed forms, and against a slow walk.
#include <QTest>
#include <cmath>
#include <limits>

#include "core/lens/batch_undistort.h"
#include "tests/core/lens_oracle.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

constexpr double focal = 520;
constexpr double turn = 6.283185307179586;

DistortionParams randomLens(Random& random, double limit) {
  const auto k = [&] { return random.uniform(-limit, limit); };
  return {k(), k(), k(), k(), k()};
}

LensOracle oracleOf(const DistortionParams& p) {
  return {p.k1, p.k2, p.p1, p.p2, p.k3};
}

LensOracle::Point complex(const Vec2& p) {
  return {p.x, p.y};
}

/// A radial lens's r_d = r (1 + k1 s + k2 s² + k3 s³), s = r², and its derivative.
struct RadialLens {
  double k1, k2, k3;
  [[nodiscard]] double distorted(double r) const {
    const double s = r * r;
    return r * (1 + s * (k1 + s * (k2 + s * k3)));
  }
  [[nodiscard]] double slope(double s) const {
    return 1 + s * (3 * k1 + s * (5 * k2 + s * 7 * k3));
  }
};

/// Where the slope turns, in order, between 0 and `end`; then `end`.
std::vector<double> turningPoints(const RadialLens& lens, double end) {
  const double a = 21 * lens.k3;
  const double b = 10 * lens.k2;
  const double root = std::sqrt(b * b - 4 * a * 3 * lens.k1);  // NaN where there is none
  std::vector<double> points{end};
  for (const double s : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
    if (s > 0 && s < end) points.push_back(s);
  std::sort(points.begin(), points.end());
  return points;
}

/// The smallest root s of the slope; `end` if there is none before; none if two roots nearly join.
std::optional<double> fold(const RadialLens& lens, double end) {
  double low = 0;
  for (double high : turningPoints(lens, end)) {
    if (std::abs(lens.slope(high)) < 1e-4) return std::nullopt;
    if (lens.slope(high) > 0) {
      low = high;
      continue;
    }
    for (int halving = 0; halving < 100; ++halving) {
      const double middle = (low + high) / 2;
      (lens.slope(middle) > 0 ? low : high) = middle;
    }
    return low;
  }
  return end;
}

}  // namespace

class TestUndistort : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void radialLensEndsAtItsFold();
  void agreesWithTheWalk();
  void theQuickInverseIsTheSame();
  void extremeLensesGiveNumbers();
  void extremePoints_data();
  void extremePoints();
};

void TestUndistort::radialLensEndsAtItsFold() {
  Random random(1);
  int folds = 0;
  for (int repeat = 0; repeat < 20000; ++repeat) {
    const auto [k1, k2, k3] =
        RadialLens{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const RadialLens radial{k1, k2, k3};
    const Distortion lens({k1, k2, 0, 0, k3});
    const auto s = fold(radial, 4);
    if (!s) continue;
    const double end = std::sqrt(*s);
    const double angle = random.uniform(0, turn);
    const auto ray = [&, angle](double rd) {
      return lens.undistort({rd * std::cos(angle), rd * std::sin(angle)});
    };
    const double furthest = radial.distorted(end);
    const auto inside = ray(0.999999 * furthest);
    QVERIFY(inside);
    const double r = std::hypot(inside->x, inside->y);
    QVERIFY(r < end);
    QVERIFY(std::abs(radial.distorted(r) - 0.999999 * furthest) < 1e-12 * (1 + furthest));
    if (*s == 4) continue;
    ++folds;
    QVERIFY(!ray(1.000001 * furthest));
  }
  QVERIFY2(folds > 5000, qPrintable(QString::number(folds)));
}

void TestUndistort::agreesWithTheWalk() {
  Random random(2);
  std::array<int, 3> ends{};
  for (int repeat = 0; repeat < 3000; ++repeat) {
    const DistortionParams params = randomLens(random, 1);
    const Vec2 q{random.uniform(-1, 1), random.uniform(-1, 1)};
    const auto walk = oracleOf(params).walk(complex(q));
    ++ends[std::size_t(walk.end)];
    if (walk.end == LensOracle::Walk::End::unclear) continue;
    const auto ideal = Distortion(params).undistort(q);
    QCOMPARE(ideal.has_value(), walk.end == LensOracle::Walk::End::ray);
    if (!ideal) continue;
    QVERIFY(std::abs(complex(*ideal) - walk.point) < 1e-6);
    QVERIFY(focal * std::abs(oracleOf(params).distort(complex(*ideal)) - complex(q)) < 1e-9);
  }
  QVERIFY2(ends[0] > 800 && ends[1] > 800 && ends[2] < 100,
           qPrintable(QString("%1 rays, %2 folds").arg(ends[0]).arg(ends[1])));
}

void TestUndistort::extremeLensesGiveNumbers() {
  Random random(3);
  int rays = 0;
  for (int repeat = 0; repeat < 20000; ++repeat) {
    const DistortionParams params = randomLens(random, 10);
    const double size = std::pow(10, random.uniform(-3, 3));
    const Vec2 q{random.uniform(-size, size), random.uniform(-size, size)};
    const auto ideal = Distortion(params).undistort(q);
    if (!ideal) continue;
    ++rays;
    QVERIFY(std::isfinite(ideal->x) && std::isfinite(ideal->y));
    QVERIFY(std::abs(oracleOf(params).distort(complex(*ideal)) - complex(q)) < 1e-10 * (1 + size));
    QVERIFY(oracleOf(params).det(complex(*ideal)) > 0);
  }
  QVERIFY(rays > 5000);
}

void TestUndistort::extremePoints_data() {
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("y");
  QTest::addColumn<bool>("isRay");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  QTest::newRow("centre") << 0.0 << 0.0 << true;
  QTest::newRow("denormal") << 5e-324 << 0.0 << true;
  QTest::newRow("very far") << 1e6 << -1e6 << true;
  QTest::newRow("infinitely far") << infinite << 0.0 << false;
  QTest::newRow("not a number") << 0.0 << nan << false;
}

void TestUndistort::extremePoints() {
  QFETCH(const double, x);
  QFETCH(const double, y);
  QFETCH(const bool, isRay);
  const Distortion lens({0.5, 0, 0, 0, 0});  // has a ray for every point
  const auto ideal = lens.undistort({x, y});
  QCOMPARE(ideal.has_value(), isRay);
  if (!isRay) return;
  const Vec2 back = lens.distort(*ideal);
  QVERIFY(std::hypot(back.x - x, back.y - y) <= 1e-13 * std::hypot(x, y));
}

void TestUndistort::theQuickInverseIsTheSame() {
  Random random(11);
  int rays = 0;
  int none = 0;
  for (int repeat = 0; repeat < 1000; ++repeat) {
    const Distortion lens(randomLens(random, repeat % 2 == 0 ? 1 : 0.05));
    const BatchUndistort quick(lens);
    constexpr int count = 150;  // more than a batch
    std::array<double, count> x;
    std::array<double, count> y;
    for (double& value : x) value = random.uniform(-1.5, 1.5);
    for (double& value : y) value = random.uniform(-1.5, 1.5);
    std::array<double, count> idealX = x;
    std::array<double, count> idealY = y;
    quick.undistort(idealX.data(), idealY.data(), count);
    for (std::size_t k = 0; k < count; ++k) {
      const auto certain = lens.undistort({x[k], y[k]});
      QCOMPARE(!std::isnan(idealX[k]), certain.has_value());
      ++(certain ? rays : none);
      if (!certain) continue;
      const Vec2 back = lens.distort({idealX[k], idealY[k]});
      QVERIFY(focal * std::hypot(back.x - x[k], back.y - y[k]) < 1e-9);
      QVERIFY(std::hypot(idealX[k] - certain->x, idealY[k] - certain->y) < 1e-6);
    }
  }
  QVERIFY2(rays > 40000 && none > 10000, qPrintable(QString("%1 %2").arg(rays).arg(none)));
}

QTEST_APPLESS_MAIN(TestUndistort)
#include "test_undistort.moc"
