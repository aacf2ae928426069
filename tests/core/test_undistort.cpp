// SPDX-License-Identifier: BSD-3-Clause
// Tests the lens's inverse on random lenses: against closed forms, and against a slow walk.
#include <QTest>
#include <cmath>
#include <limits>

#include "core/lens/batch_undistort.h"
#include "core/lens/lens_fans.h"
#include "core/lens/lens_sector.h"
#include "core/optics/lens_branch.h"
#include "tests/core/lens_oracle.h"
#include "tests/core/random.h"

using namespace hogelscope;

using Coefficients = std::array<double, 5>;  // in OpenCV's order
Q_DECLARE_METATYPE(Coefficients)

namespace {

constexpr double focal = 520;
constexpr double turn = 6.283185307179586;

DistortionParams randomLens(Random& random, double limit) {
  const auto k = [&] { return random.uniform(-limit, limit); };
  return {k(), k(), k(), k(), k()};
}

/// 1 + 3 k1 s + 5 k2 s² + 7 k3 s³ of a lens without tangential terms is (s − s₀)² (a + b s) + e: it
/// nearly touches 0, from above or below. The tangential terms are at most `tangential`.
DistortionParams touchingLens(Random& random, double least, double tangential) {
  for (;;) {
    const double s0 = random.uniform(0.05, 3);
    const double e = std::pow(10, random.uniform(std::log10(least), -1)) * (random.flip() ? 1 : -1);
    const double a = (1 - e) / (s0 * s0);
    const double b = random.uniform(-a / s0, 70);
    const double k1 = (s0 * s0 * b - 2 * s0 * a) / 3;
    const double k2 = (a - 2 * s0 * b) / 5;
    if (std::max({std::abs(k1), std::abs(k2), std::abs(b / 7)}) > 10) continue;
    return {k1, k2, random.uniform(-tangential, tangential),
            random.uniform(-tangential, tangential), b / 7};
  }
}

/// Any lens of the range: of five kinds, some near a double fold, some without tangential terms.
DistortionParams hardLens(Random& random, int kind) {
  if (kind == 0) return touchingLens(random, 1e-3, 0);
  if (kind == 1) return touchingLens(random, 1e-3, std::pow(10, random.uniform(-5, 0)));
  DistortionParams lens = randomLens(random, 10);
  const double tangential = kind == 2 ? 0 : kind == 3 ? std::pow(10, random.uniform(-5, 0)) : 1;
  lens.p1 *= tangential;
  lens.p2 *= tangential;
  return lens;
}

/// The points of a picture's rows, half as high as `height`.
struct Picture {
  int side;
  double height;
  [[nodiscard]] Vec2 at(int row, int column) const {
    const auto place = [this](int k) { return height * ((k + 0.5) / side * 2 - 1); };
    return {place(column), place(row)};
  }
};

/// Inverts a picture's points row by row, as lens tables do.
std::vector<Vec2> inverted(const BatchUndistort& inverse, const Picture& picture) {
  std::vector<Vec2> all;
  std::vector<double> x(std::size_t(picture.side));
  std::vector<double> y(x.size());
  for (int row = 0; row < picture.side; ++row) {
    for (int column = 0; column < picture.side; ++column) {
      x[std::size_t(column)] = picture.at(row, column).x;
      y[std::size_t(column)] = picture.at(row, column).y;
    }
    inverse.undistort(x.data(), y.data(), picture.side);
    for (std::size_t k = 0; k < x.size(); ++k) all.push_back({x[k], y[k]});
  }
  return all;
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

constexpr double farthest = 30;

/// Returns the last distance at which something holds that holds from near the centre on.
template <class Holds>
double lastOf(Holds holds) {
  double low = 1e-3;
  double high = farthest;
  if (holds(high)) return high;
  while (high - low > 1e-12 * high) {
    const double middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// One step of Newton's method.
Vec2 newton(const Distortion& lens, const Vec2& ideal, const Vec2& distorted) {
  const Vec2 at = lens.distort(ideal);
  const auto [xx, xy, yx, yy] = lens.jacobian(ideal);
  const double x = distorted.x - at.x;
  const double y = distorted.y - at.y;
  const double det = xx * yy - xy * yx;
  return {ideal.x + (yy * x - xy * y) / det, ideal.y + (xx * y - yx * x) / det};
}

}  // namespace

class TestUndistort : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void radialLensEndsAtItsFold();
  void agreesWithTheWalk();
  void theQuickInverseIsTheSame();
  void hardRadialLensEndsAtItsFold();
  void hardLensesAgreeWithTheWalk();
  void pathsThatNearlyTouchAFold();
  void picturesOfHardLensesAreTheSame();
  void whatHoldsOfADiscHoldsOfItsPoints();
  void sectorsAgreeWithTheWalk();
  void fansAgreeWithEachSegment();
  void tablesNearADoubleFoldNeedFewSteps();
  void stepsAreFew_data();
  void stepsAreFew();
  void stopIsHeard();
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
  QTest::newRow("very far") << 7e3 << -7e3 << true;
  QTest::newRow("farther") << 8e3 << -8e3 << false;
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

/// A millionth on either side of the fold; some lenses nearly fold before.
void TestUndistort::hardRadialLensEndsAtItsFold() {
  Random random(21);
  int folds = 0;
  for (int repeat = 0; repeat < 6000; ++repeat) {
    const DistortionParams lens =
        repeat % 2 == 0 ? touchingLens(random, 2e-4, 0) : hardLens(random, 2);
    const RadialLens radial{lens.k1, lens.k2, lens.k3};
    const auto s = fold(radial, 4);
    if (!s) continue;
    const double furthest = radial.distorted(std::sqrt(*s));
    const double angle = random.uniform(0, turn);
    const auto ray = [&, angle](double rd) {
      return Distortion(lens).undistort({rd * std::cos(angle), rd * std::sin(angle)});
    };
    const auto inside = ray(0.999999 * furthest);
    QVERIFY(inside);
    const double r = std::hypot(inside->x, inside->y);
    QVERIFY(r < std::sqrt(*s));
    QVERIFY(std::abs(radial.distorted(r) - 0.999999 * furthest) < 1e-12 * (1 + furthest));
    if (*s == 4) continue;
    ++folds;
    QVERIFY(!ray(1.000001 * furthest));
    QVERIFY(!ray(random.uniform(1, 100) * 1.000001 * furthest));
  }
  QVERIFY2(folds > 2000, qPrintable(QString::number(folds)));
}

void TestUndistort::hardLensesAgreeWithTheWalk() {
  Random random(22);
  std::array<int, 3> ends{};
  for (int repeat = 0; repeat < 2500; ++repeat) {
    const DistortionParams params = hardLens(random, repeat % 5);
    const double size = std::pow(10, random.uniform(-2, 1));
    const Vec2 q{random.uniform(-size, size), random.uniform(-size, size)};
    const auto walk = oracleOf(params).walk(complex(q));
    ++ends[std::size_t(walk.end)];
    if (walk.end == LensOracle::Walk::End::unclear) continue;
    const auto ideal = Distortion(params).undistort(q);
    QCOMPARE(ideal.has_value(), walk.end == LensOracle::Walk::End::ray);
    if (ideal) QVERIFY(std::abs(complex(*ideal) - walk.point) < 1e-6);
  }
  QVERIFY2(ends[0] > 600 && ends[1] > 600 && ends[2] < 200,
           qPrintable(QString("%1 %2 %3").arg(ends[0]).arg(ends[1]).arg(ends[2])));
}

/// On whose way the residual grows with Newton's first step.
void TestUndistort::pathsThatNearlyTouchAFold() {
  const DistortionParams params{-2.3499040207165715e-05, 0.001254227207402778, -0.17465881859086854,
                                0.00031531395378207514, 0.0036582705942063815};
  const BatchUndistort inverse{Distortion(params)};
  for (const Vec2 q :
       {Vec2{-2.619274073544243, 1.2097992357625877}, Vec2{6.565803619332879, 3.0656077721751007},
        Vec2{-6.7302423504074049, 3.1125902667678225},
        Vec2{-7.0356285652600974, 3.2535377505459881}}) {
    const auto walk = oracleOf(params).walk(complex(q), 1e-3);
    QVERIFY(walk.end == LensOracle::Walk::End::ray && walk.smallestDet < 1e-3);
    const auto ideal = Distortion(params).undistort(q);
    QVERIFY(ideal.has_value());
    QVERIFY(std::abs(complex(*ideal) - walk.point) < 1e-6);
    Vec2 quick = q;
    inverse.undistort(&quick.x, &quick.y, 1);
    QVERIFY(std::abs(complex(quick) - walk.point) < 1e-6);
  }
}

/// So what is said of sectors and ranges of directions holds for each point alone.
void TestUndistort::picturesOfHardLensesAreTheSame() {
  Random random(23);
  std::size_t rays = 0;
  std::size_t none = 0;
  for (int repeat = 0; repeat < 120; ++repeat) {
    const Distortion lens(hardLens(random, repeat % 5));
    const Picture picture{48, std::pow(10, random.uniform(-1.5, 1))};
    const std::vector<Vec2> quick = inverted(BatchUndistort(lens), picture);
    for (int k = 0; k < picture.side * picture.side; ++k) {
      const Vec2 q = picture.at(k / picture.side, k % picture.side);
      const Vec2 ideal = quick[std::size_t(k)];
      const auto certain = lens.undistort(q);
      QCOMPARE(!std::isnan(ideal.x), certain.has_value());
      ++(certain ? rays : none);
      if (!certain) continue;
      const Vec2 back = lens.distort(ideal);
      QVERIFY(std::hypot(back.x - q.x, back.y - q.y) < 1e-11 * (1 + picture.height));
      QVERIFY(std::hypot(ideal.x - certain->x, ideal.y - certain->y) < 1e-6);
    }
  }
  QVERIFY2(rays > 30000 && none > 30000, qPrintable(QString("%1 %2").arg(rays).arg(none)));
}

/// Points on the disc's border, and where all meet a fold before the end, nearer to the centre too.
void TestUndistort::whatHoldsOfADiscHoldsOfItsPoints() {
  Random random(24);
  std::array<int, 3> kinds{};
  for (int repeat = 0; repeat < 20000; ++repeat) {
    const Distortion lens(hardLens(random, repeat % 5));
    const double distance = std::pow(10, random.uniform(-2, 1));
    const double angle = random.uniform(0, turn);
    const Disc disc{{distance * std::cos(angle), distance * std::sin(angle)},
                    distance * std::pow(10, random.uniform(-3, -0.5))};
    const Branch branch = followBranch(lens, disc, {});
    ++kinds[std::size_t(branch.kind)];
    if (branch.kind == Branch::Kind::unclear) continue;
    for (int k = 0; k < 16; ++k) {
      const double part = branch.kind == Branch::Kind::none ? 1.000001 * branch.end : 1;
      const Vec2 q{part * (disc.centre.x + disc.radius * std::cos(k * turn / 16)),
                   part * (disc.centre.y + disc.radius * std::sin(k * turn / 16))};
      QCOMPARE(lens.undistort(q).has_value(), branch.kind == Branch::Kind::ray);
    }
  }
  QVERIFY2(kinds[0] > 2000 && kinds[1] > 2000, qPrintable(QString::number(kinds[0])));
}

/// On both sides of a sector: points with a ray, the roots that count as right, points without one.
void TestUndistort::sectorsAgreeWithTheWalk() {
  Random random(25);
  int rays = 0;
  int roots = 0;
  int folds = 0;
  for (int repeat = 0; repeat < 1500; ++repeat) {
    const DistortionParams params =
        touchingLens(random, 1e-3, std::pow(10, random.uniform(-6, -1)));
    const LensOracle oracle = oracleOf(params);
    const double angle = random.uniform(0, turn);
    const double halfWidth = std::pow(10, random.uniform(-3.5, -0.5));
    const LensSector sector = certifySector(Distortion(params), angle, halfWidth);
    const LensOracle::Point side = std::polar(1.0, angle + (random.flip() ? 1 : -1) * halfWidth);
    // The walk goes by the determinant, which is then large enough for it to tell.
    const auto walked = [&](LensOracle::Point q) { return oracle.walk(q, 0.005); };
    const auto reaches = [&](const LensOracle::Walk& walk, LensOracle::Point q) {
      return std::abs(oracle.distort(walk.point) - q) < 1e-6 * (1 + std::abs(q));
    };
    const LensOracle::Point inside = std::min(sector.distorted * 0.99999, 10.0) * side;
    if (sector.distorted > 0) {
      ++rays;
      const auto walk = walked(inside);
      QVERIFY(reaches(walk, inside));
      const Vec2 guess = guessInSector(Distortion(params), sector, {inside.real(), inside.imag()});
      QVERIFY(std::hypot(guess.x, guess.y) <= sector.ideal);
      QVERIFY(std::abs(walk.point) < sector.ideal);
    }
    // A root that is nearly as far out as one may be.
    const LensOracle::Point root = std::polar(random.uniform(0.97, 1) * sector.ideal, angle);
    const LensOracle::Point image = oracle.distort(root);
    const double off = std::abs(std::arg(image * std::polar(1.0, -angle)));
    if (off < halfWidth && std::abs(image) < std::min(sector.distorted, 10.0)) {
      ++roots;
      QVERIFY(std::abs(oracle.refined(walked(image).point, image) - root) < 1e-5);
    }
    if (std::isfinite(sector.dark)) {
      ++folds;
      QVERIFY(sector.dark > sector.distorted);
      const LensOracle::Point outside = 1.00001 * sector.dark * side;
      QVERIFY(!reaches(walked(outside), outside));
    }
  }
  QVERIFY2(rays > 1400 && roots > 300 && folds > 300,
           qPrintable(QString("%1 %2 %3").arg(rays).arg(roots).arg(folds)));
}

/// At the sides of neighbouring fans, where they hold least: the farthest points that still have a
/// ray by them, the nearest that have none.
void TestUndistort::fansAgreeWithEachSegment() {
  using Kind = LensFans::Place::Kind;
  Random random(27);
  int rays = 0;
  int none = 0;
  for (int repeat = 0; repeat < 1500; ++repeat) {
    const Distortion lens(hardLens(random, std::array{1, 3, 4}[std::size_t(repeat % 3)]));
    const LensFans fans(lens);
    const int count = 256 << (2 * random.integer(0, 4));
    const int first = random.integer(0, count - 1);
    for (int side = 0; side < 8; ++side) {
      const int fan = first + side / 2;
      const double angle = turn * (fan + (side % 2 == 0 ? 1e-9 : 1 - 1e-9)) / count;
      const auto point = [angle](double distance) {
        return Vec2{distance * std::cos(angle), distance * std::sin(angle)};
      };
      const auto kindAt = [&](double distance) { return fans.find(point(distance), {}).kind; };
      const double inside = lastOf([&](double distance) { return kindAt(distance) == Kind::ray; });
      if (kindAt(inside) == Kind::ray) {
        ++rays;
        const auto certain = lens.undistort(point(inside));
        QVERIFY(certain.has_value());
        Vec2 root = fans.find(point(inside), {}).line.ideal;
        for (int step = 0; step < 20; ++step) root = newton(lens, root, point(inside));
        QVERIFY(std::hypot(root.x - certain->x, root.y - certain->y) < 1e-6);
      }
      const double before = lastOf([&](double distance) { return kindAt(distance) != Kind::none; });
      if (before == farthest) continue;
      ++none;
      QVERIFY(!lens.undistort(point(1.000001 * before)));
    }
  }
  QVERIFY2(rays > 11000 && none > 3000, qPrintable(QString("%1 %2").arg(rays).arg(none)));
}

/// Lenses whose every ray took some 70 steps of its own before sectors were certified.
void TestUndistort::tablesNearADoubleFoldNeedFewSteps() {
  Random random(26);
  for (int repeat = 0; repeat < 40; ++repeat) {
    const double tangential = std::pow(10, random.uniform(-7, -3));
    int steps = 0;
    const BatchUndistort inverse(Distortion(touchingLens(random, 1e-5, tangential)), [&](double) {
      ++steps;
      return true;
    });
    constexpr int side = 200;
    (void)inverted(inverse, {side, random.uniform(0.5, 5)});
    QVERIFY2(steps < side * side / 8, qPrintable(QString::number(steps)));
  }
}

/// `most` is about 1.3 times what it took when this was written.
void TestUndistort::stepsAreFew_data() {
  QTest::addColumn<double>("height");
  QTest::addColumn<Coefficients>("k");
  QTest::addColumn<int>("most");
  QTest::newRow("folds all around") << 2.0 << Coefficients{6.18, -4.75, 0.0, 0.0, -9.02} << 25;
  QTest::newRow("grazed by segments")
      << 9.7 << Coefficients{-2.05, -3.83, 6.64, -3.92, 9.91} << 22000;
  QTest::newRow("a long valley of the determinant")
      << 26.26 << Coefficients{6.76502362, -6.54678706, 0.0803365880, 1.35738813, 3.26393743}
      << 260000;
  QTest::newRow("folds near the axis") << 6.3 << Coefficients{0.37, -0.01, 1e-5, 8e-6, -5.3} << 25;
  QTest::newRow("no fold") << 3.0 << Coefficients{10.0, 10.0, 0.1, 0.1, 10.0} << 330;
}

void TestUndistort::stepsAreFew() {
  QFETCH(const double, height);
  QFETCH(const Coefficients, k);
  QFETCH(const int, most);
  int steps = 0;
  const BatchUndistort inverse(Distortion({k[0], k[1], k[2], k[3], k[4]}), [&steps](double) {
    ++steps;
    return true;
  });
  (void)inverted(inverse, {300, height});
  QVERIFY2(steps <= most, qPrintable(QString::number(steps)));
}

void TestUndistort::stopIsHeard() {
  for (const int most : {1, 30, 300, 3000, 10000}) {
    int polls = 0;
    const auto work = [&] {
      const BatchUndistort inverse(Distortion({-2.05, -3.83, 6.64, -3.92, 9.91}),
                                   [&](double) { return ++polls < most; });
      (void)inverted(inverse, {600, 9.7});
    };
    QVERIFY_EXCEPTION_THROWN(work(), Cancelled);
    QCOMPARE(polls, most);
  }
}

QTEST_APPLESS_MAIN(TestUndistort)
#include "test_undistort.moc"
