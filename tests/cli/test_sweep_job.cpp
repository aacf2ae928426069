// SPDX-License-Identifier: BSD-3-Clause
// Tests --sweep as a user runs it: files, going on after a stop, shards, pictures of a live scene,
// what it refuses.
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>

#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"

class TestSweepJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void writesItsFiles();
  void saysWhatHasNoEffect();
  void comparesPictures();
  void leavesNoHashes();
  void goesOnAndShares();
  void solves();
  void mistakes();

 private:
  [[nodiscard]] Outcome sweep(const QStringList& more) const {
    return run(QStringList{"--sweep", "t.json", "--session", "s.json"} + more, m_folder->path());
  }
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSweepJob::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeFile("s.json",
            text({.display = R"({"size": [0.2, 0.2], "hogels": [32, 32], "directions": [12, 12]})",
                  .lightField = R"({"layout": "live", "source": "scene"})",
                  .cameras = R"([{"name": "a", "eye": [0, 0, 0.4], "res": [40, 40]}])"}));
  writeFile("t.json", R"({"parameters": {"display.directions": [[8, 8], [16, 16], [32, 32]],
                                         "display.fov": [[40, 40], [60, 60]]},
                          "figures": ["depthOfField", "megapixels", "mtf:-0.01"],
                          "pareto": {"depthOfField": "max", "megapixels": "min"}})");
}

void TestSweepJob::writesItsFiles() {
  const Outcome outcome = sweep({"--output", "out"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
  QCOMPARE(namesIn("out"), (QStringList{"plots", "sweep.csv", "sweep.html"}));
  QCOMPARE(namesIn("out/plots"), (QStringList{"parallel.csv", "parallel.svg", "parallel_page.svg",
                                              "scatter.csv", "scatter.svg", "scatter_page.svg"}));
  for (const char* const file : {"out/sweep.html", "out/plots/parallel.svg"}) {
    QXmlStreamReader reader(contentOf(file));
    while (!reader.atEnd()) reader.readNext();
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
  }
  QList<QStringList> rows = tableOf("out/sweep.csv");
  QCOMPARE(rows.takeFirst().join(","),
           QString("design,display.directions,display.fov,depthOfField,megapixels,mtf:-0.01,pareto,"
                   "problem"));
  QCOMPARE(rows.size(), 6);
  for (const QStringList& row : rows) {
    const int directions = row[1].mid(1).section(',', 0, 0).toInt();
    const double fov = row[2].mid(1).section(',', 0, 0).toDouble();
    const double depth = 0.2 / 32 * directions / (2 * std::tan(fov * std::acos(-1) / 360));
    QVERIFY(std::abs(row[3].toDouble() - depth) < 0.02 * depth);
    QCOMPARE(row[4].toDouble(), 32 * 32 * directions * directions * 1e-6);
    QCOMPARE(row[6], QString(fov == 40 ? "1" : "0"));  // the narrow field is deeper for nothing
  }
  // A line for each design in the plot, two of three of them on the front.
  QCOMPARE(contentOf("out/plots/parallel.svg").count("<polyline"), 6);
  QCOMPARE(contentOf("out/sweep.html").count("data-row=\"0\""), 1 + 5 * 4);
}

/// Without leakage its deviation changes nothing.
void TestSweepJob::saysWhatHasNoEffect() {
  writeFile("t.json", R"({"parameters": {"display.fov": [[40, 40], [60, 60]], "psf.sigma": [1, 2]},
                          "figures": ["depthOfField50"], "pass": {"depthOfField50": 0.05}})");
  const auto withWindow = [&](const char* size) {
    return sweep({"--output", size, "--set", QString("psf.windowSize=%1").arg(size)});
  };
  const QByteArray line = "psf.sigma changes none of the figures";
  const Outcome without = withWindow("1");
  QCOMPARE(without.status, 0);
  QVERIFY2(without.out.endsWith(line + "\n"), without.out);
  QVERIFY(contentOf("1/sweep.html").contains(". " + line + ".</p>"));
  QVERIFY2(without.out.contains(" of 4 designs pass") && !without.out.contains("yield"),
           without.out);
  QVERIFY2(!withWindow("5").out.contains(line), without.out);
}

void TestSweepJob::comparesPictures() {
  writeFile("t.json", R"({"parameters": {"display.directions": [[12, 12], [48, 48]]},
                          "figures": ["psnr:design", "psnr:ideal", "milliseconds"]})");
  QCOMPARE(sweep({"--output", "out"}).status, 0);
  const QList<QStringList> rows = tableOf("out/sweep.csv");
  QCOMPARE(rows[1][2], QString("inf"));  // the session's own design
  QVERIFY(rows[2][2].toDouble() > 10 && rows[2][2].toDouble() < 60);
  QVERIFY(rows[2][4].toDouble() > 0);
  // The figures of a report.
  QCOMPARE(run({"--report", "--session", "s.json", "--against", "ideal", "--output", "r", "--set",
                "display.directions=[48,48]"},
               m_folder->path())
               .status,
           0);
  QVERIFY(std::abs(tableOf("r/report.csv")[1][5].toDouble() - rows[2][3].toDouble()) < 1e-9);
}

/// The hashes of its files, which have their paths, are for runs that go on.
void TestSweepJob::leavesNoHashes() {
  writeFile("f.json", text({.display = R"({"hogels": [8, 8], "directions": [8, 8]})",
                            .lightField = R"({"file": "a.png"})",
                            .cameras = R"([{"name": "a", "eye": [0, 0, 0.4], "res": [8, 8]}])"}));
  writeFile("t.json", R"({"parameters": {"psf.sigma": [0.5, 1]}, "figures": ["psnr:design"]})");
  const auto sweepOfFile = [this](const QStringList& more) {
    return run(QStringList{"--sweep", "t.json", "--session", "f.json", "--output", "out"} + more,
               m_folder->path());
  };
  QCOMPARE(
      run({"--generate", "scene", "--session", "f.json", "--output", "a.png"}, m_folder->path())
          .status,
      0);
  QCOMPARE(sweepOfFile({"--shard", "1/2"}).status, 0);
  QVERIFY(contentOf("out/report.hashes").contains("a.png"));
  QCOMPARE(sweepOfFile({}).status, 0);
  QCOMPARE(namesIn("out"), (QStringList{"plots", "sweep.csv", "sweep.html"}));
}

void TestSweepJob::goesOnAndShares() {
  QCOMPARE(sweep({"--output", "whole"}).status, 0);
  QCOMPARE(sweep({"--output", "shared", "--shard", "2/2"}).status, 0);
  const Outcome status = run({"--status", "shared"}, m_folder->path());
  QCOMPARE(status.status, 1);
  QVERIFY2(status.out.startsWith("3 of 6 designs are done"), status.out);
  const Outcome outcome = sweep({"--output", "shared"});
  QCOMPARE(outcome.status, 0);
  QVERIFY(outcome.err.contains("went on after 3 designs"));
  QCOMPARE(contentOf("shared/sweep.csv"), contentOf("whole/sweep.csv"));
  QCOMPARE(contentOf("shared/sweep.html"), contentOf("whole/sweep.html"));
  QCOMPARE(run({"--status", "shared"}, m_folder->path()).status, 0);
}

/// The largest scatter of lenses for a yield; shards find the limits of their units.
void TestSweepJob::solves() {
  const auto solve = [](const QByteArray& more) {
    writeFile("t.json", R"({"parameters": {"twin.random.seed": {"from": 1, "to": 12}},
                            "figures": ["psnr:design", "megapixels"],
                            "solve": {"parameter": "twin.random.shift.sigma", "yield": 0.75,
                                      "pass": {"psnr:design": 25})" +
                            more + "}}");
  };
  solve(R"(, "to": 0.01)");
  const Outcome outcome = sweep({"--output", "whole"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
  QCOMPARE(namesIn("whole"), (QStringList{"plots", "sweep.csv", "sweep.html", "sweep.json"}));
  const QJsonObject found =
      QJsonDocument::fromJson(contentOf("whole/sweep.json")).object()["solve"].toObject();
  const double value = found["value"].toDouble();
  QVERIFY(value > 0 && value < 0.01);
  QCOMPARE(found["unit"].toString(), QString("m"));
  QCOMPARE(found["units"].toInt(), 12);
  QCOMPARE(found["text"].toString(), QString::fromUtf8(outcome.out).split('\n').at(1));
  QVERIFY2(outcome.out.contains("largest twin.random.shift.sigma for a yield of 75 %: "),
           outcome.out);
  QVERIFY2(outcome.out.contains(" of 12 units pass (psnr:design at least 25): yield "),
           outcome.out);
  QList<QStringList> rows = tableOf("whole/sweep.csv");
  QCOMPARE(rows.takeFirst().join(","),
           QString("design,twin.random.seed,twin.random.shift.sigma,psnr:design,megapixels,pareto,"
                   "pass,limit,problem"));
  QCOMPARE(rows.size(), 12);
  int passing = 0, within = 0;
  for (const QStringList& row : rows) {
    QCOMPARE(row[2].toDouble(), value);
    QCOMPARE(row[6], QString(row[3].toDouble() >= 25 ? "1" : "0"));
    passing += row[6].toInt();
    within += row[7].toDouble() >= value ? 1 : 0;
  }
  QCOMPARE(within, 9);
  QCOMPARE(found["passed"].toInt(), passing);
  QCOMPARE(sweep({"--output", "shared", "--shard", "1/2"}).status, 0);
  QVERIFY(!QFile::exists("shared/sweep.json"));
  const Outcome rest = sweep({"--output", "shared"});
  QVERIFY2(rest.err.contains("went on after 6 designs"), rest.err);
  for (const char* const file : {"sweep.csv", "sweep.html", "sweep.json"})
    QCOMPARE(contentOf("shared/" + QString(file)), contentOf("whole/" + QString(file)));
  // Limits of other values are others.
  QCOMPARE(sweep({"--output", "other", "--shard", "1/2"}).status, 0);
  solve(R"(, "to": 0.02)");
  QVERIFY(!sweep({"--output", "other"}).err.contains("went on"));
}

void TestSweepJob::mistakes() {
  const auto refuses = [&](const QByteArray& table, const QByteArray& line) {
    writeFile("t.json", table);
    const Outcome outcome = sweep({"--output", "o"});
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.err.startsWith("hogelscope: t.json: ") && outcome.err.contains(line),
             outcome.err);
    QCOMPARE(outcome.err.count('\n'), 1);
    QVERIFY(!QFile::exists("o/sweep.csv"));
  };
  refuses(R"({"parameters": {"psf.sigma": [1]}, "figures": ["contrasty"]})",
          "did you mean \"contrast\"?");
  refuses(R"({"parameters": {"psf.sgma": [1]}, "figures": ["contrast"]})",
          "did you mean \"sigma\"?");
  refuses("{", "");
  refuses(R"({"parameters": {"twin.random.seed": {"from": 1, "to": 3}}, "figures": ["contrast"],
              "solve": {"parameter": "twin.random.shift.sigm", "yield": 0.9,
                        "pass": {"contrast": 1}}})",
          "did you mean \"twin.random.shift.sigma\"?");
  refuses(R"({"parameters": {"nothing.sigma": [1]}, "figures": ["contrast"]})",
          "there is no section \"nothing\"");
}

QTEST_GUILESS_MAIN(TestSweepJob)
#include "test_sweep_job.moc"
