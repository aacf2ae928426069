// SPDX-License-Identifier: BSD-3-Clause
// "solve" of a sweep: the order statistic and its interval against counting and against a closed
// form, sweeps against a closed form and against a grid of all values, what is refused.
#include "measure/sweep_solve.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/base/text.h"
#include "io/plugins/plugin_library.h"
#include "measure/sweep.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

/// A live scene on a few hogels, seen by few pixels.
Session tinySession() {
  Session session;
  session.display.size = {0.2, 0.2};
  session.display.hogels = {12, 12};
  session.display.directions = {12, 12};
  session.lightField.layout = Layout::live;
  session.lightField.source = "scene";
  session.lightField.content = contentParamsOf("scene");
  session.cameras.emplace_back();
  session.cameras[0].camera.name = "a";
  session.cameras[0].camera.eye = {0.013, 0.007, 0.5};
  session.cameras[0].camera.res = {16, 16};
  return session;
}

Sweep sweepOf(const Session& session, const std::string& table) {
  SweepRequest request;
  request.session = session;
  request.table = parseSweepTable(table);
  return sweep(request, {});
}

}  // namespace

class TestSweepSolve : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The value against counting the units that pass at each limit.
  void countsLimits() {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> whole(1, 30);  // with ties
    for (int trial = 0; trial < 300; ++trial) {
      std::vector<double> limits(std::size_t(1 + trial % 40));
      for (double& limit : limits) limit = whole(random);
      const double share = 0.05 * (1 + trial % 19);
      const auto passing = [&](double value) {
        return std::ranges::count_if(limits, [&](double limit) { return limit >= value; });
      };
      double expected = 0;
      for (int value = 1; value <= 30; ++value)
        if (double(passing(value)) > share * double(limits.size()) - 1e-6) expected = value;
      const SolvedValue found = solvedValue(limits, share, 0, 100);
      QCOMPARE(found.value, expected == 0 ? NAN : expected);
      QCOMPARE(found.passed, std::size_t(passing(found.value)));
      QVERIFY(!(found.low > found.value) && !(found.high < found.value));
    }
  }

  void knowsItsEnds() {
    // 19 of 20 pass, one fails at the least value.
    std::vector<double> limits(20, infinity);
    limits[3] = NAN;
    SolvedValue found = solvedValue(limits, 0.95, 1, 7);
    QVERIFY(found.isMost);
    QCOMPARE(found.value, 7.0);
    QVERIFY(std::isnan(found.high));
    found = solvedValue(limits, 0.96, 1, 7);
    QVERIFY(std::isnan(found.value) && !found.isMost);
    QCOMPARE(found.passed, std::size_t(19));
    // Twenty units say nothing about the least limit of 95 %.
    for (std::size_t k = 0; k < limits.size(); ++k) limits[k] = double(k + 1);
    found = solvedValue(limits, 0.95, 0, 100);
    QCOMPARE(found.value, 2.0);
    QVERIFY(std::isnan(found.low));
    QCOMPARE(found.high, 4.0);  // P(B <= 3) = 0.984, P(B <= 2) = 0.925 for B of 20 and 0.05
  }

  /// e ~ N(0, σ) passes if |e| <= L, so that a unit of the draw z has the limit L/|z|, and the
  /// value is L/Φ⁻¹((1 + y)/2) = L/(√2 erf⁻¹(y)).
  void intervalsCover() {
    constexpr double yield = 0.9, limit = 0.3;
    constexpr int trials = 2000, units = 500;
    const double expected = limit / normalQuantile((1 + yield) / 2);
    QVERIFY(std::abs(std::erf(limit / (expected * std::sqrt(2.0))) - yield) < 1e-12);
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    int covered = 0, below = 0, above = 0;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> limits(units);
      for (double& one : limits) one = limit / std::abs(normal(random));
      const SolvedValue found = solvedValue(std::move(limits), yield, 0, 1e9);
      covered += found.low <= expected && expected <= found.high ? 1 : 0;
      below += expected < found.low ? 1 : 0;
      above += expected > found.high ? 1 : 0;
    }
    // Not less than 95 %, and hardly more: the binomial's steps are 1 % here.
    const double share = double(covered) / trials;
    QVERIFY2(share > 0.94 && share < 0.975, qPrintable(QString::number(share)));
    QVERIFY2(below < 0.035 * trials && above < 0.035 * trials,
             qPrintable(QString("%1 %2").arg(below).arg(above)));
  }

  /// Contrast falls with the leakage's width, so units pass up to a width s*, and those of a normal
  /// draw 1 + σ z up to σ = (s* − 1)/z.
  void solvesForADeviation() {
    Session session = tinySession();
    session.cameras[0].psf.windowSize = 7;
    const std::string parameters = R"({"parameters": {"psf.sigma": )";
    const std::string figure = R"(, "figures": ["mtf:0.02"])";
    const auto contrastOf = [&](double sigma) {
      return sweepOf(session, parameters + "[" + numberText(sigma) + "]}" + figure + "}")
          .rows[0]
          .figures[0];
    };
    const double least = contrastOf(1.1);
    QVERIFY(contrastOf(1.0) > least && contrastOf(1.2) < least);
    const Sweep found = sweepOf(
        session, parameters + R"({"normal": [1, 0.5]}}, "sampling": "latin-hypercube",
                 "count": 400, "seed": 4)" +
                     figure +
                     R"(, "solve": {"parameter": "psf.sigma.sigma", "yield": 0.95, "to": 0.2,
                         "pass": {"mtf:0.02": )" +
                     numberText(least) + "}}}");
    QVERIFY(found.solved.has_value());
    const double sigma = found.solved->value;
    QCOMPARE(found.rows.size(), std::size_t(400));
    std::vector<double> draws;
    std::size_t passing = 0;
    for (const SweepRow& row : found.rows) {
      draws.push_back((*numberOf(row.design[0]) - 1) / sigma);
      passing += row.figures[0] >= least ? 1 : 0;
      QCOMPARE(row.passes, row.figures[0] >= least);
      if (std::isfinite(row.limit)) QVERIFY(std::abs(row.limit * draws.back() / 0.1 - 1) < 2e-3);
    }
    QCOMPARE(found.solved->passed, passing);
    QVERIFY(passing == 380 || passing == 381);  // the last one may pass by rounding
    // The exact value of this sample: 20 of 400 draws are larger.
    std::ranges::sort(draws, std::greater());
    QVERIFY(std::abs(sigma * draws[20] / 0.1 - 1) < 2e-3);
    // That of all units, by the normal distribution.
    const double exact = 0.1 / normalQuantile(0.95);
    QVERIFY(found.solved->low < exact && exact < found.solved->high);
    QVERIFY(std::abs(sigma / exact - 1) < 0.02);  // the hypercube's draws are even
  }

  /// 100 units at 100 values, each measured by a plain sweep, against the solved value.
  void agreesWithAllValues() {
    Session session = tinySession();
    session.cameras[0].psf.light = LightModel::linear;
    const std::string seeds = R"({"parameters": {"twin.random.seed": {"from": 1, "to": 100})";
    const std::string figure = R"(, "figures": ["psnr:design"])";
    const Sweep all = sweepOf(session, seeds + R"(, "twin.random.gain.sigma":
        {"from": 0.002, "to": 0.2, "count": 100}})" +
                                           figure + R"(, "pass": {"psnr:design": 30}})");
    QCOMPARE(all.rows.size(), std::size_t(10000));
    std::vector<int> passing(100);
    for (std::size_t k = 0; k < all.rows.size(); ++k)
      passing[k % 100] += all.rows[k].passes ? 1 : 0;
    for (const double yield : {0.5, 0.95}) {
      int last = -1;
      while (last < 99 && passing[std::size_t(last + 1)] >= 100 * yield - 1e-9) ++last;
      QVERIFY(last > 3 && last < 95);
      const Sweep found =
          sweepOf(session, seeds + "}" + figure + R"(, "solve": {"parameter":
              "twin.random.gain.sigma", "yield": )" +
                               numberText(yield) + R"(, "pass": {"psnr:design": 30}}})");
      const double value = found.solved->value / 0.002 - 1;  // in steps of the grid
      QVERIFY2(value > last - 1 && value < last + 2,
               qPrintable(QString("%1 %2").arg(value).arg(last)));
      QVERIFY2(std::abs(double(found.solved->passed) - 100 * yield) <= 3, found.solvedText.c_str());
    }
  }

  void saysItsEnds() {
    const auto textOf = [](const std::string& solve) {
      return QString::fromStdString(
          sweepOf(tinySession(), R"({"parameters": {"twin.random.seed": {"from": 1, "to": 20}},
              "figures": ["megapixels"], "solve": {"parameter": "twin.random.shift.sigma",)" +
                                     solve + "}}")
              .solvedText);
    };
    QCOMPARE(textOf(R"("yield": 0.95, "pass": {"megapixels": 1})"),
             QString("no twin.random.shift.sigma has a yield of 95 %: at the least, 0 m, 0 of 20 "
                     "units pass"));
    QCOMPARE(
        textOf(R"("yield": 0.9, "to": 0.001, "pass": {"megapixels": {"max": 1}})"),
        QString("even the largest twin.random.shift.sigma, 0.001 m, has a yield of 90 %: 20 of "
                "20 units pass"));
  }

  void mistakes_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("line");
    const auto row = [](const char* name, const QString& parameters, const QString& solve,
                        const QString& line) {
      QTest::newRow(name) << R"({"parameters": {)" + parameters +
                                 R"(}, "figures": ["megapixels"], "solve": )" + solve + "}"
                          << line;
    };
    const QString seeds = R"("twin.random.seed": {"from": 1, "to": 4})";
    const QString pass = R"(, "pass": {"megapixels": 1}})";
    const auto of = [&](const QString& parameter) {
      return QString(R"({"yield": 0.9, "parameter": "%1")").arg(parameter) + pass;
    };
    const QString good = of("psf.sigma").chopped(1);
    row("no object", seeds, "3", "solve: is not an object");
    row("no parameter", seeds, R"({"yield": 0.9)" + pass, "solve.parameter: is missing");
    row("no yield", seeds, R"({"parameter": "psf.sigma")" + pass, "solve.yield: is missing");
    row("yield of 1", seeds, R"({"parameter": "psf.sigma", "yield": 1)" + pass,
        "solve.yield: 1 is not between 0 and 1");
    row("no pass", seeds, R"({"parameter": "psf.sigma", "yield": 0.9})", "solve.pass: is missing");
    row("empty pass", seeds, R"({"parameter": "psf.sigma", "yield": 0.9, "pass": {}})",
        "solve.pass: has no limit");
    row("other figure", seeds, R"({"parameter": "psf.sigma", "yield": 0.9, "pass": {"mtf:0": 1}})",
        "solve.pass.mtf:0: is none of the figures");
    row("two passes", seeds, of("psf.sigma") + R"(, "pass": {"megapixels": 1})",
        "pass: is for a sweep without solve");
    row("misspelt", seeds, good + R"(, "form": 1})", "did you mean \"from\"?");
    row("unknown", seeds, of("twin.random.shift.sigmo"),
        "did you mean \"twin.random.shift.sigma\"?");
    row("no number", seeds, of("twin.random.rotation.sigma"), "is neither a number of the session");
    row("deviation", seeds + R"(, "twin.lensArray.rotation": [0.1])",
        of("twin.lensArray.rotation.sigma"), "is neither a number of the session");
    row("list", seeds, of("twin.lensArray.offset"), "has 2 numbers");
    row("whole", seeds, of("twin.light.bits"), "is a whole number");
    row("given", seeds + R"(, "twin.lensArray.rotation": [0.1])", of("twin.lensArray.rotation"),
        "is one of the parameters");
    row("no units", R"("display.fov": [[30, 30]])", of("twin.lensArray.rotation"),
        "solve: needs units that are drawn");
    row("too low", seeds, good + R"(, "from": -1})", "solve.from: -1 is less");
    row("too high", seeds, good + R"(, "to": 1e9})", "solve.to: 1e+09 is more");
    row("backwards", seeds, good + R"(, "from": 2, "to": 1})", "solve.to: 1 is not above from, 2");
  }
  void mistakes() {
    QFETCH(QString, text);
    QFETCH(QString, line);
    const QString error = errorOf([&] { (void)sweepOf(tinySession(), text.toStdString()); });
    QVERIFY2(error.contains(line) && !error.contains('\n'), qPrintable(error));
  }
};

QTEST_GUILESS_MAIN(TestSweepSolve)
#include "test_sweep_solve.moc"
