// SPDX-License-Identifier: BSD-3-Clause
// Tests what is said about the ways to invert a lens, its maps and its table.
#include <QTest>
#include <cmath>

#include "core/lens/lens_certificate.h"
#include "study/stability.h"
#include "tests/core/lens_oracle.h"

using namespace hogelscope;

namespace {

constexpr int side = 41;

const InverseMethod& method(const std::string& name) {
  for (const InverseMethod& each : inverseMethods())
    if (each.name == name) return each;
  throw std::invalid_argument(name);
}

LensOutcomes outcomes(const LensKey& lens, const std::string& name) {
  return LensTrial(lens, side, side).outcomes(method(name));
}

const LensKey& hardLens(std::size_t index) {
  static const std::vector<NamedLens> lenses = hardLenses();
  return lenses[index].key;
}

/// How many points of the grid have a ray, by the slow walk.
std::size_t raysByWalking(const LensKey& lens) {
  const auto& [k1, k2, p1, p2, k3, k4, k5, k6, model] = lens.distortion;
  const LensOracle oracle(k1, k2, p1, p2, k3, k4, k5, k6);
  const FisheyeOracle fisheye(k1, k2, k3, k4);
  const auto walk = [&, isFisheye = model == DistortionModel::fisheye](LensOracle::Point q) {
    return isFisheye ? fisheye.walk(q) : oracle.walk(q);
  };
  std::size_t rays = 0;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double x = double(column) * (lens.res[0] - 1) / (side - 1) - lens.centre.x;
      const double y = double(row) * (lens.res[1] - 1) / (side - 1) - lens.centre.y;
      if (walk({x / lens.focalLength.x, y / lens.focalLength.y}).end == LensOracle::Walk::End::ray)
        ++rays;
    }
  }
  return rays;
}

}  // namespace

class TestStability : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void knownFiguresOfThePapersLenses();
  void knownOtherLenses();
  void oursIsRightWhereverThereIsARay_data();
  void oursIsRightWhereverThereIsARay();
  void aWrongRootIsNotTakenForARightOne();
  void rowsAddUp();
  void mapAtKnownPlaces();
  void threadsDoNotMatter();
  void oursHoldsOverTheMaps();
  void foldLineOfRadialLenses();
  void foldLineOfTangentialLenses();
  void tableHasItsColumns();
  void stops();

 private:
  Stability m_stability;
};

void TestStability::initTestCase() {
  m_stability = measureStability(hardLenses(), serialRows, {});
}

/// docs/formulas.md, Known failures. The first figures are about a principal point at 300, half a
/// pixel off, as they were published first.
void TestStability::knownFiguresOfThePapersLenses() {
  const auto theirs = [](std::size_t index) {
    LensKey lens = hardLens(index);
    lens.centre = {300, 300};
    return lens;
  };
  QVERIFY(std::abs(outcomes(theirs(0), "OpenCV 5").worstResidual - 19.6) < 0.05);
  QVERIFY(std::abs(outcomes(theirs(2), "OpenCV 5").worstResidual - 105) < 0.5);
  QCOMPARE(outcomes(theirs(1), "OpenCV 200")[Outcome::diverged], std::size_t(367));
  QVERIFY(std::isinf(outcomes(theirs(1), "OpenCV 200").worstResidual));
  // About the picture's middle, 299.5.
  QVERIFY(std::abs(outcomes(hardLens(0), "OpenCV 5").worstResidual - 19.29) < 0.01);
  QVERIFY(std::abs(outcomes(hardLens(2), "OpenCV 5").worstResidual - 105.58) < 0.01);
  QCOMPARE(outcomes(hardLens(1), "OpenCV 200")[Outcome::diverged], std::size_t(363));
}

void TestStability::knownOtherLenses() {
  // (-0.45, 0.25): between 1.042 and 1.406 for ever; 0.294 focal lengths off, 170 px for f = 579.
  const LensOutcomes cycle = outcomes(hardLens(3), "OpenCV 200");
  const double corner = cycle.worstResidual / hardLens(3).focalLength.x;
  QVERIFY2(std::abs(corner * 579 - 170) < 1, qPrintable(QString::number(corner)));
  QVERIFY(cycle[Outcome::diverged] >= 4);
  // k1 = 0.5 to r_d = 3: more iterations are worse.
  QVERIFY(outcomes(hardLens(4), "OpenCV 200").worstResidual >
          outcomes(hardLens(4), "OpenCV 5").worstResidual + 100);
  // OpenCV's own: the corner has no ray.
  QVERIFY(outcomes(hardLens(5), "ours")[Outcome::noRay] > 100);
  QVERIFY(outcomes(hardLens(5), "Newton 20")[Outcome::wrongRoot] > 0);
}

void TestStability::oursIsRightWhereverThereIsARay_data() {
  QTest::addColumn<int>("index");
  for (int k = 0; k < int(hardLenses().size()); ++k)
    QTest::newRow(hardLenses()[std::size_t(k)].name.c_str()) << k;
}

void TestStability::oursIsRightWhereverThereIsARay() {
  QFETCH(const int, index);
  const LensKey& lens = hardLens(std::size_t(index));
  const LensOutcomes ours = outcomes(lens, "ours");
  QCOMPARE(ours[Outcome::right], raysByWalking(lens));
  QCOMPARE(ours[Outcome::right] + ours[Outcome::noRay], std::size_t(side * side));
  QVERIFY(ours.worstResidual < 1e-9);
}

void TestStability::aWrongRootIsNotTakenForARightOne() {
  // r (1 - r²/2) = 0.5: the other root is -1.618, on the branch that came back through the centre.
  LensKey lens = paperCamera({-0.5, 0, 0, 0, 0});
  lens.res = {3, 3};
  lens.focalLength = {1000, 1000};
  lens.centre = {-499, 1};  // the middle pixel lies at (0.5, 0)
  const auto answer = [&lens](double root) {
    const InverseMethod said{
        "", false, [root](const Distortion&, const std::vector<Vec2>& points, const Progress&) {
          return std::vector<Vec2>(points.size(), Vec2{root, 0});
        }};
    return LensTrial(lens, 3, 3).outcomes(said);
  };
  const double wrong = -(1 + std::sqrt(5.0)) / 2;
  QCOMPARE(answer(wrong)[Outcome::wrongRoot], std::size_t(1));
  const double right = Distortion(lens.distortion).undistort({0.5, 0})->x;
  QCOMPARE(answer(right)[Outcome::right], std::size_t(1));
  QCOMPARE(answer(right - 1e-4)[Outcome::right], std::size_t(0));
  QCOMPARE(answer(right + 1)[Outcome::right], std::size_t(0));
  QCOMPARE(answer(NAN)[Outcome::diverged], std::size_t(9));
}

void TestStability::rowsAddUp() {
  for (const auto& lens : m_stability.outcomes)
    for (const LensOutcomes& o : lens) QCOMPARE(o.points(), std::size_t(side * side));
  QCOMPARE(m_stability.maps.size(), std::size_t(2));
  for (const LensMap& map : m_stability.maps) {
    QCOMPARE(map.outcomes.size(), inverseMethods().size());
    for (const auto& lenses : map.outcomes) {
      QCOMPARE(lenses.size(), std::size_t(map.plane.side() * map.plane.side()));
      for (const LensOutcomes& o : lenses) QCOMPARE(o.points(), std::size_t(81));
    }
  }
}

void TestStability::mapAtKnownPlaces() {
  const LensMap& map = m_stability.maps[0];
  const auto at = [&map](std::size_t m, double k1, double k2) {
    const auto index = [&map](double k) {
      return std::size_t(std::lround((k + 1) * map.plane.stepsPerUnit));
    };
    return map.outcomes[m][index(k2) * std::size_t(map.plane.side()) + index(k1)].worst();
  };
  for (std::size_t m = 0; m < inverseMethods().size(); ++m)
    QCOMPARE(at(m, 0, 0), Outcome::right);      // no lens at all
  QCOMPARE(at(0, 0.5, 0.5), Outcome::inexact);  // OpenCV's five iterations do not suffice
  QCOMPARE(at(2, 0.5, 0.5), Outcome::right);    // 200 do
  QCOMPARE(at(2, -1, 1), Outcome::diverged);    // though there is a ray,
  QCOMPARE(at(4, -1, 1), Outcome::right);
  QCOMPARE(at(3, -1, -0.5), Outcome::wrongRoot);  // Newton beyond the fold
  QCOMPARE(at(4, -1, -0.5), Outcome::noRay);
}

void TestStability::threadsDoNotMatter() {
  LensPlane coarse = lensPlanes()[0];
  coarse.stepsPerSide = coarse.stepsPerUnit = 4;
  const LensMap one = measureMap(coarse, serialRows, {});
  const LensMap two = measureMap(coarse, parallelRows, {});
  for (std::size_t m = 0; m < inverseMethods().size(); ++m)
    for (std::size_t k = 0; k < one.outcomes[m].size(); ++k)
      QVERIFY(one.outcomes[m][k].each == two.outcomes[m][k].each);
  QVERIFY(!one.foldLine.empty());
  QCOMPARE(one.foldLine.size(), two.foldLine.size());
  for (std::size_t k = 0; k < one.foldLine.size(); ++k)
    for (std::size_t at = 0; at < one.foldLine[k].size(); ++at) {
      QCOMPARE(one.foldLine[k][at].x, two.foldLine[k].at(at).x);
      QCOMPARE(one.foldLine[k][at].y, two.foldLine[k].at(at).y);
    }
}

void TestStability::oursHoldsOverTheMaps() {
  for (const LensMap& map : m_stability.maps) {
    for (const LensOutcomes& o : map.outcomes.back()) {
      QCOMPARE(o[Outcome::right] + o[Outcome::noRay], o.points());
      QVERIFY(o.worstResidual < 1e-9);
    }
  }
}

/// On the line the fold's circle, of the closed form's and of the certificate's radius, goes
/// through the picture's corner; where it is new-born (a double root of the slope) it may jump in.
void TestStability::foldLineOfRadialLenses() {
  const LensKey camera = paperCamera({});
  const double corner = std::sqrt(2.0) * camera.centre.x / camera.focalLength.x;
  int checked = 0;
  for (const auto& piece : m_stability.maps[0].foldLine) {
    for (const Vec2& k : piece) {
      // 1 + 3 k1 s + 5 k2 s² = 0, s = r².
      const double discriminant = 9 * k.x * k.x - 20 * k.y;
      if (discriminant < 0.02 || (k.x < 0 && k.y > 0.1)) continue;
      ++checked;
      const double s = 2 / (-3 * k.x + std::sqrt(discriminant));
      const double r = std::sqrt(s);
      QVERIFY(std::abs(r * (1 + k.x * s + k.y * s * s) - corner) < 1e-3);
      QVERIFY(std::abs(validRadius(Distortion({k.x, k.y, 0, 0, 0})) - r) < 1e-6);
    }
  }
  QVERIFY2(checked > 40, qPrintable(QString::number(checked)));
}

/// For p1 = 1, p2 = 0 the fold is 4x² = (1 + 2y)(1 + 6y). Its image, which shrinks as 1 / p1, meets
/// the picture's diagonal first.
void TestStability::foldLineOfTangentialLenses() {
  double low = -1 / 6.0;  // the image (X, Y) has X + Y < 0 here,
  double high = 0;        // and above 0 here
  double reach = 0;
  for (int halving = 0; halving < 60; ++halving) {
    const double y = (low + high) / 2;
    const double x = std::sqrt((1 + 2 * y) * (1 + 6 * y)) / 2;
    reach = x + 2 * x * y;
    (reach + y + x * x + 3 * y * y < 0 ? low : high) = y;
  }
  const LensKey camera = paperCamera({});
  const double expected = reach / (camera.centre.x / camera.focalLength.x);  // 0.125
  int onAxes = 0;
  for (const auto& piece : m_stability.maps[1].foldLine) {
    for (const Vec2& p : piece) {
      QVERIFY(std::hypot(p.x, p.y) > 0.05 && std::hypot(p.x, p.y) < 0.2);
      if (std::min(std::abs(p.x), std::abs(p.y)) > 1e-9) continue;
      ++onAxes;
      QVERIFY(std::abs(std::max(std::abs(p.x), std::abs(p.y)) - expected) < 2e-4);
    }
  }
  QCOMPARE(onAxes, 5);  // the first one closes the line
}

void TestStability::tableHasItsColumns() {
  const QStringList lines = QString::fromStdString(csv(m_stability)).split('\n');
  QCOMPARE(lines.front(),
           QString("kind,lens,method,points,right,wrong_root,inexact,diverged,no_ray,"
                   "worst_residual_px,outcome,x,y,value"));
  QVERIFY(lines.back().isEmpty());
  QStringList kinds;
  for (const QString& line : lines.mid(1, lines.size() - 2)) {
    QCOMPARE(line.count(','), 13);  // no name of a lens here has a comma
    const QStringList cells = line.split(',');
    if (!kinds.contains(cells[0])) kinds << cells[0];
    if (cells[4].isEmpty()) continue;
    int sum = 0;
    for (int k = 4; k < 9; ++k) sum += cells[k].toInt();
    QCOMPARE(sum, cells[3].toInt());
  }
  QCOMPARE(kinds,
           QStringList({"lens", "k1_k2", "p1_p2", "psf_gain", "psnr_mean", "near_panel", "grazing",
                        "scale", "origin", "pupil_focus", "pupil_width", "undistortion"}));
}

void TestStability::stops() {
  int heard = 0;
  QVERIFY_EXCEPTION_THROWN(
      (void)measureStability(hardLenses(), serialRows, [&heard](double) { return ++heard < 9; }),
      Cancelled);
  QCOMPARE(heard, 9);
}

QTEST_APPLESS_MAIN(TestStability)
#include "test_stability.moc"
