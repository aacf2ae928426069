// SPDX-License-Identifier: BSD-3-Clause
// Tests --sweep as a user runs it: files, going on after a stop, shards, pictures of a live scene,
// what it refuses.
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
  QCOMPARE(namesIn("out/plots"),
           (QStringList{"parallel.csv", "parallel.svg", "scatter.csv", "scatter.svg"}));
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
  refuses(R"({"parameters": {"nothing.sigma": [1]}, "figures": ["contrast"]})",
          "there is no section \"nothing\"");
}

QTEST_GUILESS_MAIN(TestSweepJob)
#include "test_sweep_job.moc"
