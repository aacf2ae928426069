// SPDX-License-Identifier: BSD-3-Clause
// Tests --measure as a user runs it: files, the law in the table, going on after a stop, shards,
// what it refuses.
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>
#include <csignal>

#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"

namespace {

const QByteArray session =
    text({.display = R"({"size": [0.2, 0.2], "hogels": [48, 48], "directions": [16, 16]})",
          .lightField = R"({"file": "missing.png"})",
          .cameras = R"([{"name": "a", "eye": [0, 0, 0.5], "psf": {"sigma": 0.67, "windowSize": 5}},
                    {"name": "b", "eye": [0, 0, 1]}])"});

const QStringList names{
    "angular_profile", "angular_resolution", "crosstalk", "crosstalk_matrix", "mtf",
    "through_focus",   "viewing_zone"};

bool isXml(const QString& file) {
  QXmlStreamReader reader(contentOf(file));
  while (!reader.atEnd()) reader.readNext();
  return !reader.hasError();
}

}  // namespace

class TestMeasureJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void writesItsFiles();
  void readsWell();
  void goesOnAndShares();
  void ofRealDisplays_data();
  void ofRealDisplays();
  void mistakes_data();
  void mistakes();

 private:
  [[nodiscard]] Outcome measure(const QStringList& more) const {
    return run(QStringList{"--measure", "--session", "s.json"} + more, m_folder->path());
  }
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestMeasureJob::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeFile("s.json", session);
}

void TestMeasureJob::writesItsFiles() {
  const Outcome outcome = measure({"--output", "out"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
  QVERIFY(outcome.out.contains("depthOfField"));
  QCOMPARE(namesIn("out"), (QStringList{"measure.csv", "measure.html", "plots"}));
  QVERIFY(isXml("out/measure.html"));
  QStringList files;
  for (const QString& name : names) files << name + ".csv" << name + ".svg" << name + "_page.svg";
  files.sort();
  QCOMPARE(namesIn("out/plots"), files);
  for (const QString& name : names) {
    QVERIFY(isXml("out/plots/" + name + ".svg"));
    QVERIFY(contentOf("out/plots/" + name + ".svg").startsWith("<svg xmlns="));
    QVERIFY(contentOf("out/plots/" + name + ".svg").contains("width=\"86mm\""));
    QVERIFY(contentOf("out/plots/" + name + "_page.svg").contains("width=\"178mm\""));
    QVERIFY(tableOf("out/plots/" + name + ".csv").size() > 5);
  }

  QList<QStringList> rows = tableOf("out/measure.csv");
  QCOMPARE(rows.takeFirst().join(","), QString("figure,value,unit,where,closed_form,difference"));
  QSet<QString> figures;
  const double pitch = 0.2 / 48;
  const double slope = 2 * std::tan(std::acos(-1) / 6) / 16;
  int gratings = 0;
  for (const QStringList& row : rows) {
    QCOMPARE(row.size(), 6);
    figures << row[0];
    const double value = row[1].toDouble();
    if (!row[5].isEmpty() && row[1] != "inf")
      QVERIFY(std::abs(value - row[4].toDouble() - row[5].toDouble()) < 1e-12);
    if (row[0] == "depthOfField") {
      QVERIFY(std::abs(row[4].toDouble() - pitch / slope) < 1e-12);
      QVERIFY(std::abs(value - pitch / slope) < 0.02 * pitch / slope);
    }
    if (row[0] != "mtf") continue;
    // The row's own words, and the law worked out from them here.
    const double f = 1000 * row[3].section('=', 1, 1).section('/', 0, 0).toDouble();
    const double z = row[3].section("z=", 1, 1).section(' ', 0, 0).toDouble();
    const auto sinc = [](double x) {
      return x == 0 ? 1 : std::sin(std::acos(-1) * x) / (std::acos(-1) * x);
    };
    double leaked = 0, sum = 0;
    for (int k = -2; k <= 2; ++k) {
      const double weight = std::exp(-k * k / (2 * 0.67 * 0.67));
      leaked += weight * std::cos(2 * std::acos(-1) * f * slope * z * k);
      sum += weight;
    }
    const double law = std::abs(sinc(f * pitch) * sinc(f * slope * z) * leaked / sum);
    QVERIFY2(std::abs(row[4].toDouble() - law) < 2e-3, qPrintable(row.join(" ")));
    QVERIFY2(std::abs(value - law) < 0.015, qPrintable(row.join(" ")));
    ++gratings;
  }
  QCOMPARE(gratings, 41 * 24);
  for (const char* name : {"hogelPitch",
                           "slopeStep",
                           "degreesPerDirection",
                           "directionsPerPupil",
                           "megapixels",
                           "viewingZone",
                           "qualifiedViewingSpace",
                           "crosstalk",
                           "crosstalkMatrix",
                           "angularProfile",
                           "angularResolution",
                           "spatialResolution",
                           "mtf",
                           "uniformity",
                           "contrast",
                           "depthOfField",
                           "depthOfField50",
                           "depthOfField10",
                           "depthFront",
                           "depthBehind",
                           "parallaxStep",
                           "throughFocus",
                           "diffraction"})
    QVERIFY2(figures.remove(name), name);
  QVERIFY(figures.isEmpty());
}

/// Both eyes see one of three directions, so that their crosstalk is infinite; lengths are in mm.
void TestMeasureJob::readsWell() {
  const Outcome outcome =
      measure({"--output", "out", "--set", "display.directions=[3,3]", "--set", "psf.windowSize=1",
               "--set", "camera.eye=[0,0,1.2]", "--states", "a"});
  QCOMPARE(outcome.status, 0);
  const auto lineOf = [&outcome](const char* figure) {
    for (const QByteArray& line : outcome.out.split('\n'))
      if (line.startsWith(QByteArray("  ") + figure + " ")) return line.trimmed();
    return QByteArray();
  };
  QCOMPARE(lineOf("crosstalk"), QByteArray("crosstalk (x=0 m): ∞, closed form ∞"));
  QCOMPARE(lineOf("hogelPitch"), QByteArray("hogelPitch (across): 4.167 mm, closed form 4.167"));
  QVERIFY(!outcome.out.contains("identical"));
  const QByteArray page = contentOf("out/measure.html");
  QVERIFY(
      page.contains("<td>hogelPitch</td><td>across</td><td class=\"n\">4.167</td><td>mm</td>"
                    "<td class=\"n\">4.167</td>"));
  QVERIFY(contentOf("out/measure.csv").contains("\nhogelPitch,0.00416"));  // metres
}

void TestMeasureJob::goesOnAndShares() {
  QCOMPARE(measure({"--output", "whole"}).status, 0);
  QProcess process;
  start(process, {"--measure", "--session", "s.json", "--output", "killed", "--threads", "1"},
        m_folder->path());
  QVERIFY(waitUntil(process, [] { return QFileInfo("killed/report.journal").size() > 3000; }));
  process.kill();
  waitForEnd(process);
  if (QFile::exists("killed/report.journal")) {
    QCOMPARE(run({"--status", "killed"}, m_folder->path()).status, 1);
    const Outcome outcome = measure({"--output", "killed"});
    QCOMPARE(outcome.status, 0);
    QVERIFY(outcome.err.contains("went on after"));
  }
  for (const char* const shard : {"1/3", "2/3", "3/3"})
    QCOMPARE(measure({"--output", "shared", "--shard", shard}).status, 0);
  QVERIFY(!QFile::exists("shared/measure.csv"));
  const Outcome outcome = measure({"--output", "shared", "--threads", "1"});
  QCOMPARE(outcome.status, 0);
  QVERIFY(outcome.err.contains("went on after"));
  for (const char* const folder : {"killed", "shared"}) {
    for (const char* const file : {"measure.csv", "measure.html", "plots/mtf.svg"})
      QCOMPARE(contentOf(QString(folder) + "/" + file), contentOf(QString("whole/") + file));
    QCOMPARE(namesIn(folder), namesIn("whole"));
  }
  // Another display's journal is not taken up.
  QCOMPARE(measure({"--output", "o", "--shard", "1/9"}).status, 0);
  QCOMPARE(measure({"--output", "o", "--set", "display.fov=[50,50]"}).status, 0);
  QVERIFY(contentOf("o/measure.csv") != contentOf("whole/measure.csv"));
}

void TestMeasureJob::ofRealDisplays_data() {
  QTest::addColumn<double>("depth");      // p/s, metres
  QTest::addColumn<double>("frequency");  // 1/(2p), per mm
  QTest::newRow("paper") << 0.50743 << 0.512;
  QTest::newRow("looking_glass_portrait") << 0.03214 << 1.026;
  QTest::newRow("looking_glass_27_class") << 0.02952 << 0.8717;
  QTest::newRow("integral_imaging_8k") << 0.01596 << 0.5005;
}

/// Figures of the samples, worked out by hand.
void TestMeasureJob::ofRealDisplays() {
  QFETCH(double, depth);
  QFETCH(double, frequency);
  writeFile("t.json", R"({"parameters": {"psf.windowSize": [1]},
                          "figures": ["depthOfField", "hogelPitch", "viewingZone"]})");
  const QString file = QString(HOGELSCOPE_SOURCE_DIR "/data/displays/") + QTest::currentDataTag();
  const Outcome outcome =
      run({"--sweep", "t.json", "--session", file + ".json", "--output", "o"}, m_folder->path());
  QCOMPARE(outcome.err, QByteArray());
  const QStringList row = tableOf("o/sweep.csv")[1];
  QVERIFY2(std::abs(row[2].toDouble() - depth) < 0.02 * depth, qPrintable(row.join(" ")));
  QVERIFY2(std::abs(0.5e-3 / row[3].toDouble() - frequency) < 1e-3, qPrintable(row.join(" ")));
  QVERIFY(row[4].toDouble() > 0);  // the eye sees all of the panel from somewhere
}

void TestMeasureJob::mistakes_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("line");
  QTest::newRow("behind") << QStringList{"--set", "camera.eye=[0,0,-1]"}
                          << QByteArray("a: its eye is not in front of the panel");
  QTest::newRow("no directions") << QStringList{"--set", "display.directions=[0,0]"}
                                 << QByteArray("display.directions");
  QTest::newRow("over the session") << QStringList{"--states", "c"} << QByteArray("--states c");
  QTest::newRow("shard") << QStringList{"--shard", "3/2"} << QByteArray("--shard 3/2");
}

void TestMeasureJob::mistakes() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, line);
  const Outcome outcome = measure(QStringList{"--output", "o"} + arguments);
  QCOMPARE(outcome.status, 2);
  QVERIFY2(outcome.err.contains(line), outcome.err);
  QCOMPARE(outcome.err.count('\n'), 1);
}

QTEST_GUILESS_MAIN(TestMeasureJob)
#include "test_measure_job.moc"
