// SPDX-License-Identifier: BSD-3-Clause
// Leakage and its transpose against a loop over the window; the solver against coordinate descent,
// which minimises the same by other means; its bound.
#include <QTest>
#include <cmath>
#include <random>

#include "optimise/hogel_solver.h"

using namespace hogelscope;

namespace {

using Plane = HogelLeakage::Plane;
using Matrix = std::vector<std::vector<double>>;

PsfParams psfOf(double sigma, int window, PsfBorder border) {
  return {sigma, window, border, LightModel::encoded};
}

Plane random(int du, int dv, int margin, std::mt19937_64& engine, bool isBinary = false) {
  Plane plane(du, dv, margin);
  std::uniform_real_distribution<double> any(0, 1);
  for (int v = 0; v < dv; ++v)
    for (int u = 0; u < du; ++u) plane.row(v)[u] = isBinary ? std::round(any(engine)) : any(engine);
  return plane;
}

double product(const Plane& a, const Plane& b) {
  double sum = 0;
  for (int v = 0; v < a.dv; ++v)
    for (int u = 0; u < a.du; ++u) sum += a.row(v)[u] * b.row(v)[u];
  return sum;
}

/// The matrix of docs/formulas.md, Light leakage: rows are what is seen.
Matrix matrixOf(const PsfParams& psf, int du, int dv) {
  const int n = psf.windowSize / 2;
  Matrix matrix(std::size_t(du * dv), std::vector<double>(std::size_t(du * dv), 0));
  for (int v = 0; v < dv; ++v)
    for (int u = 0; u < du; ++u) {
      double inside = 0, whole = 0;
      std::vector<double>& row = matrix[std::size_t(v * du + u)];
      for (int y = -n; y <= n; ++y)
        for (int x = -n; x <= n; ++x) {
          const double weight =
              n == 0 ? 1 : std::exp(-(x * x + y * y) / (2 * psf.sigma * psf.sigma));
          whole += weight;
          int a = u + x, b = v + y;
          const bool isIn = a >= 0 && a < du && b >= 0 && b < dv;
          if (psf.border == PsfBorder::clamp) {
            a = std::clamp(a, 0, du - 1);
            b = std::clamp(b, 0, dv - 1);
          } else if (!isIn) {
            continue;
          }
          inside += weight;
          row[std::size_t(b * du + a)] += weight;
        }
      for (double& weight : row) weight /= psf.border == PsfBorder::renormalise ? inside : whole;
    }
  return matrix;
}

/// Minimises Σ W (L x − t)² over 0 ≤ x ≤ 1, texel after texel, until nothing changes.
double leastByCoordinates(const Matrix& matrix, const Plane& weights, const Plane& targets) {
  const std::size_t n = matrix.size();
  const auto at = [&](const Plane& plane, std::size_t k) {
    return plane.row(int(k) / plane.du)[int(k) % plane.du];
  };
  std::vector<double> x(n, 0.5), residual(n);
  for (std::size_t k = 0; k < n; ++k) {
    residual[k] = -at(targets, k);
    for (std::size_t j = 0; j < n; ++j) residual[k] += matrix[k][j] * x[j];
  }
  for (int round = 0; round < 20000; ++round) {
    double most = 0;
    for (std::size_t j = 0; j < n; ++j) {
      double slope = 0, bend = 0;
      for (std::size_t k = 0; k < n; ++k) {
        slope += at(weights, k) * matrix[k][j] * residual[k];
        bend += at(weights, k) * matrix[k][j] * matrix[k][j];
      }
      if (bend == 0) continue;
      const double step = std::clamp(x[j] - slope / bend, 0.0, 1.0) - x[j];
      x[j] += step;
      for (std::size_t k = 0; k < n; ++k) residual[k] += matrix[k][j] * step;
      most = std::max(most, std::abs(step));
    }
    if (most < 1e-13) break;
  }
  double error = 0;
  for (std::size_t k = 0; k < n; ++k) error += at(weights, k) * residual[k] * residual[k];
  return error;
}

Plane ones(int du, int dv, int margin) {
  Plane plane(du, dv, margin);
  for (int v = 0; v < dv; ++v) std::fill_n(plane.row(v), du, 1.0);
  return plane;
}

}  // namespace

class TestHogelSolver : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void leakageAndItsTranspose_data() {
    QTest::addColumn<int>("border");
    QTest::addColumn<double>("sigma");
    QTest::addColumn<int>("window");
    for (const int border : {0, 1, 2})
      for (const auto& [sigma, window] : {std::pair(0.67, 5), std::pair(1.5, 9), std::pair(1.0, 1)})
        QTest::newRow(qPrintable(QString("%1 %2 %3").arg(border).arg(sigma).arg(window)))
            << border << sigma << window;
  }

  void leakageAndItsTranspose() {
    QFETCH(int, border);
    QFETCH(double, sigma);
    QFETCH(int, window);
    const PsfParams psf = psfOf(sigma, window, PsfBorder(border));
    constexpr int du = 7, dv = 5;
    const HogelLeakage leakage(psf, du, dv);
    const Matrix matrix = matrixOf(psf, du, dv);
    std::mt19937_64 engine(3);
    const int margin = leakage.across().reach();
    Plane seen(du, dv, margin), back(du, dv, margin), work(du, dv, margin);
    for (int trial = 0; trial < 5; ++trial) {
      const Plane x = random(du, dv, margin, engine);
      const Plane y = random(du, dv, margin, engine);
      leakage.apply(x, seen, work);
      for (int k = 0; k < du * dv; ++k) {
        double expected = 0;
        for (int j = 0; j < du * dv; ++j)
          expected += matrix[std::size_t(k)][std::size_t(j)] * x.row(j / du)[j % du];
        QVERIFY(std::abs(seen.row(k / du)[k % du] - expected) < 1e-13);
      }
      leakage.applyTransposed(y, back, work);
      QVERIFY(std::abs(product(seen, y) - product(x, back)) < 1e-12 * product(seen, y));
    }
  }

  void theLeastErrorIsFound() {
    std::mt19937_64 engine(11);
    int clipped = 0;
    for (int trial = 0; trial < 12; ++trial) {
      const PsfParams psf = psfOf(trial % 2 == 0 ? 0.67 : 1, 5, PsfBorder(trial % 3));
      const HogelLeakage leakage(psf, 8, 8);
      std::vector<HogelTerm> terms{{&leakage, random(8, 8, 2, engine), random(8, 8, 2, engine)}};
      const double least =
          leastByCoordinates(matrixOf(psf, 8, 8), terms[0].weights, terms[0].targets);
      Plane x = terms[0].targets;
      HogelSolver solver(8, 8, 2);
      const HogelSolution found = solver.solve(terms, ones(8, 8, 2), {20000, 0}, x);
      QVERIFY2(std::abs(found.after - least) < 1e-5 * least,
               qPrintable(QString("%1 %2").arg(found.after).arg(least)));
      QVERIFY(found.after < found.before);
      for (int k = 0; k < 64; ++k) {
        const double value = x.row(k / 8)[k % 8];
        QVERIFY(value >= 0 && value <= 1);
        clipped += value == 0 || value == 1 ? 1 : 0;
      }
    }
    QVERIFY(clipped > 100);
  }

  void theBoundIsNeverAboveTheLeastError() {
    std::mt19937_64 engine(5);
    for (int trial = 0; trial < 100; ++trial) {
      const PsfParams psf = psfOf(trial % 2 == 0 ? 0.67 : 1.5, 5, PsfBorder(trial % 3));
      const HogelLeakage leakage(psf, 6, 6);
      std::vector<HogelTerm> terms{
          {&leakage, random(6, 6, 2, engine, trial % 4 == 0), random(6, 6, 2, engine, true)}};
      const double least =
          leastByCoordinates(matrixOf(psf, 6, 6), terms[0].weights, terms[0].targets);
      HogelSolver solver(6, 6, 2);
      double bound = 0;
      for (const int iterations : {1, 5, 40, 2000}) {
        Plane x = random(6, 6, 2, engine);
        bound = solver.solve(terms, ones(6, 6, 2), {iterations, 0}, x).bound;
        QVERIFY2(bound <= least * (1 + 1e-9) + 1e-12,
                 qPrintable(QString("%1 %2").arg(bound).arg(least)));
      }
      QVERIFY(bound > 0.9 * least - 1e-3);
    }
  }

  /// Without leakage the targets themselves are best; white and black in turn gain nothing.
  void whatNeedsNoChangeStays() {
    std::mt19937_64 engine(7);
    const HogelLeakage none(psfOf(1, 1, PsfBorder::renormalise), 9, 6);
    std::vector<HogelTerm> terms{{&none, ones(9, 6, 0), random(9, 6, 0, engine)}};
    Plane x = terms[0].targets;
    HogelSolution found = HogelSolver(9, 6, 0).solve(terms, ones(9, 6, 0), {}, x);
    QCOMPARE(found.after, 0.0);
    QCOMPARE(x.values, terms[0].targets.values);

    const HogelLeakage leakage(psfOf(0.67, 5, PsfBorder::renormalise), 20, 20);
    Plane halves(20, 20, 2);
    for (int v = 0; v < 20; ++v) std::fill_n(halves.row(v), 10, 1.0);
    terms = {{&leakage, ones(20, 20, 2), halves}};
    x = halves;
    found = HogelSolver(20, 20, 2).solve(terms, ones(20, 20, 2), {}, x);
    QVERIFY(found.after > 0.999 * found.before);
    QCOMPARE(x.values, halves.values);
  }

  /// A dead pixel is the bound 0, and its neighbours make up for it as far as they can.
  void deadPixels() {
    std::mt19937_64 engine(9);
    const HogelLeakage leakage(psfOf(0.67, 5, PsfBorder::renormalise), 8, 8);
    std::vector<HogelTerm> terms{{&leakage, ones(8, 8, 2), random(8, 8, 2, engine)}};
    Plane most = ones(8, 8, 2);
    most.row(3)[4] = 0;
    Plane x = terms[0].targets;
    const HogelSolution found = HogelSolver(8, 8, 2).solve(terms, most, {2000, 0}, x);
    QCOMPARE(x.row(3)[4], 0.0);
    QVERIFY(found.after < found.before);
    QVERIFY(found.bound <= found.after);
  }

  void severalLeakagesAreSummed() {
    std::mt19937_64 engine(13);
    const HogelLeakage first(psfOf(0.67, 5, PsfBorder::renormalise), 8, 8);
    const HogelLeakage second(psfOf(1, 5, PsfBorder::clamp), 8, 8);
    const Plane weights = random(8, 8, 2, engine), targets = random(8, 8, 2, engine);
    Plane x = targets, same = targets;
    HogelSolver solver(8, 8, 2);
    Plane twice = weights;
    for (double& weight : twice.values) weight *= 2;
    const HogelSolution both = solver.solve(
        {{&first, weights, targets}, {&first, weights, targets}}, ones(8, 8, 2), {60, 0}, x);
    const HogelSolution one =
        solver.solve({{&first, twice, targets}}, ones(8, 8, 2), {60, 0}, same);
    QVERIFY(std::abs(both.after - one.after) < 1e-9 * one.after);
    x = targets;
    const HogelSolution mixed = solver.solve(
        {{&first, weights, targets}, {&second, weights, targets}}, ones(8, 8, 2), {2000, 0}, x);
    QVERIFY(mixed.after > 0 && mixed.bound <= mixed.after && mixed.bound > 0.9 * mixed.after);
  }
};

QTEST_APPLESS_MAIN(TestHogelSolver)
#include "test_hogel_solver.moc"
