// SPDX-License-Identifier: BSD-3-Clause
// Sweeps: designs of a table, the Pareto front against brute force, figures against those of
// --measure, errors in tables.
#include "measure/sweep.h"

#include <QTest>
#include <cmath>
#include <random>
#include <set>

#include "core/base/text.h"
#include "measure/measure_run.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

SweepTable tableOf(const std::string& parameters, const std::string& more = "") {
  return parseSweepTable(R"({"parameters": )" + parameters + R"(, "figures": ["megapixels"])" +
                         more + "}");
}

Session smallSession() {
  Session session;
  session.display.size = {0.2, 0.2};
  session.display.hogels = {40, 40};
  session.display.directions = {12, 12};
  session.lightField.file = "missing.png";
  session.cameras.emplace_back();
  session.cameras[0].camera.name = "a";
  session.cameras[0].camera.eye = {0, 0, 0.5};
  return session;
}

}  // namespace

class TestSweep : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void grids() {
    const SweepTable table = tableOf(
        R"({"display.directions": [[10, 10], [20, 20]], "psf.sigma": {"from": 0.5, "to": 2, "count": 4},
            "psf.windowSize": {"from": 3, "to": 5}})");
    const auto designs = designsOf(table);
    QCOMPARE(designs.size(), std::size_t(2 * 4 * 3));
    QVERIFY(designs[0] == (Design{"[10,10]", "0.5", "3"}));
    QVERIFY(designs[1] == (Design{"[10,10]", "0.5", "4"}));
    QVERIFY(designs[3] == (Design{"[10,10]", "1", "3"}));
    QVERIFY(designs.back() == (Design{"[20,20]", "2", "5"}));
    QVERIFY(overridesOf(table, designs[1]) ==
            (std::vector<std::string>{"display.directions=[10,10]", "psf.sigma=0.5",
                                      "psf.windowSize=4"}));
  }

  /// Seeds and counts are whole numbers: 14 is no 14.000000000000002.
  void wholeNumbersStayWhole() {
    for (const char* const more : {"", R"(, "count": 100)"}) {
      const auto designs = designsOf(
          tableOf(R"({"twin.random.seed": {"from": 1, "to": 100)" + std::string(more) + "}}"));
      QCOMPARE(designs.size(), std::size_t(100));
      for (std::size_t k = 0; k < 100; ++k) QCOMPARE(designs[k][0], std::to_string(k + 1));
    }
    const auto tenths = designsOf(tableOf(R"({"a.b": {"from": 0.1, "to": 0.7, "count": 4}})"));
    QCOMPARE(tenths.front()[0], std::string("0.1"));
    QCOMPARE(tenths.back()[0], std::string("0.7"));
  }

  /// Each value of a Latin hypercube lies in a stratum of its own.
  void hypercubes() {
    const std::string parameters =
        R"({"psf.sigma": {"from": 1.5, "to": 3.5}, "psf.windowSize": {"from": 1, "to": 4},
            "display.fov": [[30, 30], [60, 60]], "a.b": {"normal": [5, 2]}})";
    const SweepTable table =
        tableOf(parameters, R"(, "sampling": "latin-hypercube", "count": 40, "seed": 3)");
    const auto designs = designsOf(table);
    QCOMPARE(designs.size(), std::size_t(40));
    std::set<int> strata, normal;
    std::map<std::string, int> windows, fields;
    for (const Design& design : designs) {
      strata.insert(int((*numberOf(design[0]) - 1.5) / 2 * 40));
      ++windows[design[1]];
      ++fields[design[2]];
      const double x = (*numberOf(design[3]) - 5) / 2;
      normal.insert(int(0.5 * std::erfc(-x / std::sqrt(2.0)) * 40));
    }
    QCOMPARE(strata.size(), std::size_t(40));
    QCOMPARE(normal.size(), std::size_t(40));
    QCOMPARE(windows, (std::map<std::string, int>{{"1", 10}, {"2", 10}, {"3", 10}, {"4", 10}}));
    QCOMPARE(fields, (std::map<std::string, int>{{"[30,30]", 20}, {"[60,60]", 20}}));
    QVERIFY(designsOf(table) == designs);
    const SweepTable other =
        tableOf(parameters, R"(, "sampling": "latin-hypercube", "count": 40, "seed": 4)");
    QVERIFY(designsOf(other) != designs);
    QVERIFY(std::abs(normalQuantile(0.975) - 1.959963984540054) < 1e-12);
  }

  void paretoFront() {
    SweepTable table;
    table.figures = {"depthOfField", "megapixels", "crosstalk"};
    table.pareto = {{"depthOfField", 1}, {"megapixels", -1}};
    std::mt19937 random(4);
    std::uniform_int_distribution<int> uniform(0, 9);  // with ties
    std::vector<SweepRow> rows;
    for (int k = 0; k < 200; ++k)
      rows.push_back({{}, {double(uniform(random)), double(uniform(random)), 0}, false, ""});
    rows[7].figures[0] = NAN;
    markPareto(table, rows);
    for (const SweepRow& row : rows) {
      bool isBest = !std::isnan(row.figures[0]);
      for (const SweepRow& by : rows)
        if (by.figures[0] >= row.figures[0] && by.figures[1] <= row.figures[1] &&
            (by.figures[0] > row.figures[0] || by.figures[1] < row.figures[1]))
          isBest = false;
      QCOMPARE(row.isPareto, isBest);
    }
    table.pareto.clear();
    markPareto(table, rows);
    QVERIFY(std::ranges::none_of(rows, &SweepRow::isPareto));
  }

  /// Units are drawn; the designs of a grid are no sample, of which a share would say something.
  void onlyUnitsHaveAYield() {
    const auto textOf = [](const std::string& parameters, const std::string& sampling) {
      const SweepTable table = tableOf(parameters, R"(, "pass": {"megapixels": 1})" + sampling);
      std::vector<SweepRow> rows(4);
      rows[2].passes = true;
      return QString::fromStdString(yieldText(table, rows));
    };
    const std::string hypercube = R"(, "sampling": "latin-hypercube", "count": 4)";
    const QString designs = "1 of 4 designs pass (megapixels at least 1)";
    const QString units = "1 of 4 units pass (megapixels at least 1): yield 25.0 % (4.6 … 69.9 %)";
    const std::string fov = R"({"display.fov": [[30, 30], [60, 60]]})";
    QCOMPARE(textOf(fov, ""), designs);
    QCOMPARE(textOf(fov, hypercube), designs);
    QCOMPARE(textOf(R"({"psf.sigma": {"normal": [1, 0.1]}})", hypercube), units);
    QCOMPARE(textOf(R"({"twin.random.seed": {"from": 1, "to": 4}})", ""), units);
    const std::string rotation = R"({"twin.lensArray.rotation": {"from": 0, "to": 1, "count": 2}})";
    QCOMPARE(textOf(rotation, hypercube), units);
    QCOMPARE(textOf(rotation, ""), designs);
  }

  void parametersWithoutEffect() {
    const SweepTable table = parseSweepTable(
        R"({"parameters": {"psf.sigma": [1, 2], "display.fov": [[30, 30], [60, 60]],
                           "psf.windowSize": [1], "camera.fov": [20, 30]},
            "figures": ["megapixels", "crosstalk", "milliseconds"]})");
    std::vector<SweepRow> rows;
    double time = 0;
    for (const Design& design : designsOf(table))
      rows.push_back({design, {design[1] == "[30,30]" ? 1.0 : 2.0, NAN, ++time}, false, "", false});
    QCOMPARE(effectText(table, rows),
             std::string("psf.sigma, camera.fov change none of the figures"));
    rows[3].problem = "cannot be measured";
    rows[3].figures = {NAN, NAN, NAN};
    QCOMPARE(effectText(table, rows),
             std::string("psf.sigma, camera.fov change none of the figures"));
    rows[0].figures[1] = 0.1;  // its neighbours along all axes differ from it
    QCOMPARE(effectText(table, rows), std::string());
    QCOMPARE(effectText(table, {}), std::string());
    SweepTable withGoals = table;
    withGoals.pareto = {{"megapixels", -1}};
    rows[3].problem.clear();
    rows[3].figures[0] = 2;
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].figures[1] = k < 4 ? 1 : 2;
    QCOMPARE(effectText(withGoals, rows),
             std::string("camera.fov changes none of the figures; psf.sigma changes none of the "
                         "goals of the Pareto front"));
  }

  void headsHaveUnits() {
    SweepRequest request;
    request.session = smallSession();
    request.table = parseSweepTable(
        R"({"parameters": {"display.fov": [[40, 40]], "twin.lensArray.rotation": [0.1],
                           "camera.eye": [[0, 0, 1]], "depth.comfort": [1]},
            "figures": ["viewingZone", "mtf:0.02", "psnr:ideal", "milliseconds", "megapixels",
                        "depthOfField50"]})");
    const std::string page = sweepPage(request, {});
    for (const char* const head :
         {"display.fov (°)", "twin.lensArray.rotation (°)", "camera.eye (m)", "depth.comfort (°)",
          "viewingZone (m)", "mtf:0.02", "psnr:ideal (dB)", "milliseconds (ms)", "megapixels (Mpx)",
          "depthOfField50 (m)"})
      QVERIFY2(page.find(">" + std::string(head) + "</th>") != std::string::npos, head);
    QVERIFY(page.find("mtf:Z is the contrast itself") != std::string::npos);
    QVERIFY(csv(request.table, {}).starts_with("design,display.fov,twin.lensArray.rotation,"));
  }

  void figuresAreThoseOfMeasure() {
    SweepRequest request;
    request.session = smallSession();
    request.table = parseSweepTable(
        R"({"parameters": {"display.directions": [[8, 8], [16, 16], [999999, 1]]},
            "figures": ["depthOfField", "mtf:0.02", "viewingZone", "crosstalk", "angularProfile"]})");
    const Sweep result = sweep(request, {});
    QCOMPARE(result.rows.size(), std::size_t(3));
    for (const int k : {0, 1}) {
      Session session = request.session;
      session.display.directions = {k == 0 ? 8 : 16, k == 0 ? 8 : 16};
      Bench bench = benchOf(session, displayToMeasure(session, {}));
      std::map<std::string, double> expected;
      for (const Measurement& one : measurementsOf(session, bench))
        if (one.figure == "depthOfField" || one.where == "full width at half maximum" ||
            one.where.starts_with("whole panel across") || one.where == "x=0 m")
          expected[one.figure] = one.simulate(bench);
      const SweepRow& row = result.rows[std::size_t(k)];
      QCOMPARE(row.figures[0], expected["depthOfField"]);
      QCOMPARE(row.figures[2], expected["viewingZone"]);
      QCOMPARE(row.figures[3], expected["crosstalk"]);
      QCOMPARE(row.figures[4], expected["angularProfile"]);
      // sinc(1/2) sinc(f s z)
      const double pi = std::acos(-1);
      const double pitch = 0.2 / 40;
      const double slope = 2 * std::tan(pi / 6) / session.display.directions[0];
      const double x = pi * 0.02 * slope / (2 * pitch);
      QVERIFY(std::abs(row.figures[1] - 2 / pi * std::sin(x) / x) < 0.01);
    }
    // A design that cannot be has a problem, and does not stop the others.
    QVERIFY(!result.rows[2].problem.empty());
    QVERIFY(std::isnan(result.rows[2].figures[0]));
    const std::string table = csv(request.table, result.rows);
    QVERIFY(
        table.starts_with("design,display.directions,depthOfField,mtf:0.02,viewingZone,"
                          "crosstalk,angularProfile,pareto,problem\n1,\"[8,8]\","));
  }

  void mistakes_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("line");
    const QString end = R"(, "figures": ["megapixels"]})";
    QTest::newRow("no object") << "[]"
                               << "table: is not an object";
    QTest::newRow("no parameters") << R"({"figures": ["megapixels"]})"
                                   << "parameters: is missing";
    QTest::newRow("no section") << R"({"parameters": {"sigma": [1]})" + end
                                << "parameters.sigma: is not section.field";
    QTest::newRow("no list") << R"({"parameters": {"psf.sigma": 1})" + end
                             << "parameters.psf.sigma: is neither a list";
    QTest::newRow("no values") << R"({"parameters": {"psf.sigma": []})" + end
                               << "parameters.psf.sigma: is neither a list";
    QTest::newRow("no end") << R"({"parameters": {"psf.sigma": {"from": 1}})" + end
                            << "parameters.psf.sigma.to: is missing";
    QTest::newRow("backwards")
        << R"({"parameters": {"psf.sigma": {"from": 1, "to": 0, "count": 2}})" + end
        << "parameters.psf.sigma.to: is less";
    QTest::newRow("no count") << R"({"parameters": {"psf.sigma": {"from": 1, "to": 1.5}})" + end
                              << "parameters.psf.sigma.count: is missing";
    QTest::newRow("normal grid") << R"({"parameters": {"psf.sigma": {"normal": [1, 0.1]}})" + end
                                 << "which a grid cannot be";
    QTest::newRow("too many")
        << R"({"parameters": {"a.b": {"from": 0, "to": 99999}, "c.d": {"from": 0, "to": 99999}})" +
               end
        << "more than 1000000 designs";
    QTest::newRow("misspelt") << R"({"parameters": {"psf.sigma": {"form": 0, "to": 1}})" + end
                              << "did you mean \"from\"?";
    QTest::newRow("unknown key") << R"({"parameters": {"a.b": [1]}, "extra": 3)" + end
                                 << "extra: is not known here";
    QTest::newRow("sampling") << R"({"parameters": {"a.b": [1]}, "sampling": "random")" + end
                              << "neither grid nor latin-hypercube";
    QTest::newRow("count") << R"({"parameters": {"a.b": [1]}, "sampling": "latin-hypercube")" + end
                           << "count: is missing";
    QTest::newRow("goal") << R"({"parameters": {"a.b": [1]}, "pareto": {"megapixels": "low"})" + end
                          << "neither \"max\" nor \"min\"";
    QTest::newRow("goal of nothing")
        << R"({"parameters": {"a.b": [1]}, "pareto": {"contrast": "max"})" + end
        << "pareto.contrast: is none of the figures";
    QTest::newRow("no figures") << R"({"parameters": {"a.b": [1]}, "figures": []})"
                                << "figures: is not a list";
    QTest::newRow("unknown figure")
        << R"({"parameters": {"psf.sigma": [1]}, "figures": ["depthOfFeild"]})"
        << "did you mean \"depthOfField\"?";
    QTest::newRow("contrast without a plane")
        << R"({"parameters": {"psf.sigma": [1]}, "figures": ["mtf"]})"
        << "\"mtf\" is none of mtf:Z (on the plane Z in metres), psnr:ideal";
    QTest::newRow("psnr of what is not live")
        << R"({"parameters": {"psf.sigma": [1]}, "figures": ["psnr:ideal"]})"
        << "only a 3-D scene has an ideal view";
    QTest::newRow("unknown parameter")
        << R"({"parameters": {"psf.sigmo": [1]})" + end << "did you mean \"sigma\"?";
    QTest::newRow("damaged") << R"({"parameters": )"
                             << "parse";
  }

  void mistakes() {
    QFETCH(QString, text);
    QFETCH(QString, line);
    const QString error = errorOf([&] {
      SweepRequest request;
      request.session = smallSession();
      request.table = parseSweepTable(text.toStdString());
      (void)sweep(request, {});
    });
    QVERIFY2(error.contains(line) || line == "parse", qPrintable(error));
    QVERIFY2(!error.isEmpty() && !error.contains('\n'), qPrintable(error));
  }
};

QTEST_GUILESS_MAIN(TestSweep)
#include "test_sweep.moc"
