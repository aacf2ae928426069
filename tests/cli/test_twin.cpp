// SPDX-License-Identifier: BSD-3-Clause
// Tests twins as a user meets them: --twin, reports against the design, content for one unit,
// tolerances, and what each refuses.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

namespace {

const QByteArray room =
    R"({"layout": "live", "source": "mesh", "mesh": {"file": ")" HOGELSCOPE_SOURCE_DIR
    R"(/data/room.glb"}})";

/// The sample data's room on a panel of 60×60 hogels of 8 mm and 16×16 directions.
QByteArray session(const QByteArray& twin, const QByteArray& lightField = room) {
  return R"({"hogelscope": 1, "display": {"size": [0.48, 0.48], "hogels": [60, 60],
             "directions": [16, 16], "fov": [60, 60]}, )" +
         (twin.isEmpty() ? QByteArray() : "\"twin\": " + twin + ", ") + R"("lightField": )" +
         lightField + R"(, "cameras": [
             {"name": "a", "eye": [0, 0, 0.8], "fov": 32, "res": [120, 100],
              "psf": {"light": "linear"}},
             {"name": "b", "eye": [0.1, 0.04, 0.8], "fov": 32, "res": [120, 100],
              "psf": {"light": "linear"}}]})";
}

double valueOf(const QString& file, int row, const QString& column) {
  const auto table = tableOf(file);
  return table[row][table[0].indexOf(column)].toDouble();
}

}  // namespace

class TestTwin : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void rendersTheUnit();
  void againstTheDesign();
  void streamed();
  void resumes();
  void contentForTheUnit();
  void contentEvensGains();
  void drawnTwinsAreTheSame();
  void measuredDirections();
  void yieldOfTolerances();
  void mistakes_data();
  void mistakes();

 private:
  [[nodiscard]] Outcome program(const QStringList& arguments) const {
    return run(arguments, m_folder->path());
  }
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestTwin::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeFile("s.json", session({}));
  writeFile("offset.json", R"({"lensArray": {"offset": [1e-4, 1e-4]}})");
  writeFile("turned.json", R"({"twin": {"lensArray": {"rotation": 0.05}}})");
  writeFile("zero.json", "{}");
}

/// A named twin, the same one in the session and --twin are one picture; a zero twin is the design.
void TestTwin::rendersTheUnit() {
  writeFile("named.json", session("\"turned.json\""));
  writeFile("held.json", session(R"({"lensArray": {"rotation": 0.05}})"));
  const auto rendered = [this](const QStringList& arguments, const QString& folder) {
    const Outcome outcome =
        program(QStringList{"--render", "--output", folder, "--session"} + arguments);
    if (outcome.status != 0) qWarning("%s", outcome.err.constData());
    return contentOf(folder + "/a.png");
  };
  const QByteArray design = rendered({"s.json"}, "design");
  const QByteArray built = rendered({"s.json", "--twin", "turned.json"}, "built");
  QVERIFY(!design.isEmpty() && built != design);
  QCOMPARE(rendered({"named.json"}, "named"), built);
  QCOMPARE(rendered({"held.json"}, "held"), built);
  QCOMPARE(rendered({"named.json", "--twin", "zero.json"}, "zero"), design);
  QCOMPARE(
      rendered({"s.json", "--twin", "turned.json", "--set", "twin.lensArray.rotation=0"}, "set"),
      design);
}

/// An offset moves all rays alike; a rotation does not.
void TestTwin::againstTheDesign() {
  const Outcome outcome =
      program({"--report", "--session", "s.json", "--against", "design", "--twin", "offset.json",
               "--twin", "turned.json", "--twin", "zero.json", "--output", "out"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
  const auto rows = tableOf("out/metrics.csv");
  QCOMPARE(rows.size(), 7);
  QCOMPARE(rows[1].mid(0, 2), (QStringList{"a", "offset.json"}));
  // 0.1 mm across and up are 0.1/q pixels of q = p/16.
  const double moved = std::sqrt(2.0) * 1e-4 / (8e-3 / 16);
  QVERIFY(std::abs(valueOf("out/metrics.csv", 1, "move_rms") - moved) < 0.002);
  QVERIFY(valueOf("out/metrics.csv", 1, "move_rest") < 1e-4);
  const double turned = valueOf("out/metrics.csv", 2, "move_rms");
  QVERIFY(turned > 0.1);
  QVERIFY(valueOf("out/metrics.csv", 2, "move_rest") > 0.9 * turned);
  QCOMPARE(rows[3][rows[0].indexOf("move_rms")], QString("0"));
  QCOMPARE(tableOf("out/report.csv")[3][3], QString("inf"));
  QVERIFY2(outcome.out.contains("offset.json: all its rays are shifted equally by"), outcome.out);
  QVERIFY(
      contentOf("out/report.html").contains("offset.json: all its rays are shifted equally by"));
  QVERIFY(
      !contentOf("out/report.html").contains("turned.json: all its rays are shifted equally by"));
  QVERIFY(
      contentOf("out/report.html").contains("<h1>Units as built against the design of s.json<"));
  QVERIFY(contentOf("out/report.html").contains("<p>Of 3 units half have a mean PSNR of"));
  for (const char* name : {"units_mean_psnr_seen", "units_mean_move_rest", "yield_mean_psnr_seen",
                           "yield_mean_move_rest"}) {
    QVERIFY(QFileInfo::exists(QString("out/plots/%1.svg").arg(name)));
    QCOMPARE(tableOf(QString("out/plots/%1.csv").arg(name)).size(), 4);
  }
}

/// Units read the file of the design, which has one decoder, also where it is streamed.
void TestTwin::streamed() {
  QCOMPARE(program({"--export", "hogels", "--session", "s.json", "--output", "content.png"}).status,
           0);
  writeFile("picture.json", session({}, R"({"file": "content.png"})"));
  const auto figures = [this](const QString& folder, const QStringList& more) {
    const Outcome outcome =
        program(QStringList{"--report", "--session", "picture.json", "--against", "design",
                            "--twin", "turned.json", "--output", folder} +
                more);
    if (outcome.status != 0) qWarning("%s", outcome.err.constData());
    return contentOf(folder + "/metrics.csv");
  };
  const QByteArray whole = figures("whole", {});
  for (int k = 0; k < 3; ++k) QCOMPARE(figures("streamed", {"--memory", "4"}), whole);
}

/// A twin's document that changed is another report.
void TestTwin::resumes() {
  const QStringList report{"--report", "--session",   "s.json",   "--against", "design",
                           "--twin",   "turned.json", "--output", "out"};
  const auto shard = [&](const char* which) {
    return program(report + QStringList{"--shard", which}).status;
  };
  QCOMPARE(shard("1/2"), 0);
  QVERIFY(program(report).err.contains("went on after 1 views"));
  QCOMPARE(shard("1/2"), 0);
  writeFile("turned.json", R"({"lensArray": {"rotation": 0.06}})");
  QVERIFY(!program(report).err.contains("went on"));
}

/// Content along the twin's own rays comes nearer to the scene than the design's content.
void TestTwin::contentForTheUnit() {
  const QByteArray twin = R"({"lensArray": {"offset": [4e-4, 0], "rotation": 0.2, "gapError": 0.03},
                             "random": {"shift": {"sigma": 3e-4}}})";
  writeFile("built.json", session(twin));
  QCOMPARE(program({"--export", "hogels", "--session", "s.json", "--output", "content.png"}).status,
           0);
  writeFile("recorded.json", session(twin, R"({"file": "content.png"})"));
  for (const char* name : {"built", "recorded"}) {
    const QString file = name;
    const Outcome outcome = program({"--export", "hogels", "--for-twin", "--session",
                                     file + ".json", "--output", file + ".png"});
    QCOMPARE(outcome.err, QByteArray());
  }
  const Outcome outcome =
      program({"--report", "--session", "built.json", "--against", "ideal", "--test", "content.png",
               "--test", "built.png", "--test", "recorded.png", "--output", "out"});
  QCOMPARE(outcome.err, QByteArray());
  for (const int state : {0, 1}) {
    const auto psnr = [&](int test) {
      return valueOf("out/report.csv", 4 * state + test, "psnr_seen");
    };
    QVERIFY(std::abs(psnr(1) - psnr(2)) < 1e-9);  // live content, and the same as a file
    QVERIFY2(psnr(3) > psnr(2) + 1, qPrintable(QString("%1 %2").arg(psnr(3)).arg(psnr(2))));
    QVERIFY2(psnr(4) > psnr(2) + 0.5, qPrintable(QString("%1 %2").arg(psnr(4)).arg(psnr(2))));
  }
}

/// White content, divided by the gains, is even through them, and as dim as the dimmest hogel.
void TestTwin::contentEvensGains() {
  const QByteArray field = R"({"file": "white.png"})";
  writeImageFile("white.png", 960, 960, [](int, int, int) { return 1.0F; });
  writeFile("built.json", session(R"({"random": {"gain": {"sigma": 0.1}}})", field));
  QCOMPARE(program({"--export", "hogels", "--for-twin", "--session", "built.json", "--output",
                    "even.png"})
               .status,
           0);
  writeFile("even.json", contentOf("built.json").replace("white.png", "even.png"));
  const auto spread = [this](const QString& document) {
    if (program({"--render", "--session", document, "--output", "out"}).status != 0) return 999;
    const QImage picture = QImage("out/a.png");
    int least = 255, most = 0;
    for (int x = 40; x < 80; ++x)
      for (int y = 30; y < 70; ++y) {
        least = std::min(least, qGreen(picture.pixel(x, y)));
        most = std::max(most, qGreen(picture.pixel(x, y)));
      }
    return most - least;
  };
  QVERIFY(spread("built.json") > 30);
  QVERIFY2(spread("even.json") <= 2, qPrintable(QString::number(spread("even.json"))));
}

/// A twin whose errors were drawn and written shows the same picture without random numbers.
void TestTwin::drawnTwinsAreTheSame() {
  writeFile("random.json", R"({"lensArray": {"rotation": 0.05}, "random": {"seed": 4,
    "shift": {"sigma": 1e-4, "length": 3}, "gain": {"sigma": 0.1}}})");
  const Outcome outcome = program({"--make-twin", "--session", "s.json", "--twin", "random.json",
                                   "--output", "units/drawn.json"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.out, QByteArray("units/drawn.json, units/drawn.hogels.exr: 60×60 hogels\n"));
  QVERIFY(!contentOf("units/drawn.json").contains("random"));
  for (const char* twin : {"random.json", "units/drawn.json"})
    QCOMPARE(program({"--render", "--session", "s.json", "--twin", twin, "--output",
                      QString(twin).section('.', 0, 0).section('/', -1)})
                 .status,
             0);
  QVERIFY(!contentOf("random/a.png").isEmpty());
  QCOMPARE(contentOf("drawn/a.png"), contentOf("random/a.png"));
  QCOMPARE(contentOf("drawn/b.png"), contentOf("random/b.png"));
}

/// A goniometer's table of the designed slopes is the design; one line says what was fitted.
void TestTwin::measuredDirections() {
  QByteArray table = "u,v,x,y\n";
  const double slope = 2 * std::tan(std::acos(-1.0) / 6) / 16;  // of a direction of 60 degrees
  for (int v = 0; v < 16; ++v)
    for (int u = v % 2; u < 16; u += 2)
      table += QString("%1,%2,%3,%4\n")
                   .arg(u)
                   .arg(v)
                   .arg(slope * (u - 7.5), 0, 'g', 17)
                   .arg(slope * (7.5 - v), 0, 'g', 17)
                   .toUtf8();
  writeFile("table.csv", table);
  writeFile("measured.json", R"({"maps": {"directions": "table.csv"}})");
  const Outcome outcome = program({"--report", "--session", "s.json", "--against", "design",
                                   "--twin", "measured.json", "--output", "out"});
  QVERIFY2(outcome.err.startsWith("hogelscope: warning: table.csv: has 128 of 256 directions;") &&
               outcome.err.count('\n') == 1,
           outcome.err);
  QVERIFY(valueOf("out/metrics.csv", 1, "move_rms") < 1e-5);
}

void TestTwin::yieldOfTolerances() {
  writeFile("t.json", R"({"parameters": {"twin.random.seed": {"from": 1, "to": 4},
    "twin.random.shift.sigma": [1e-6, 1e-3]}, "sampling": "grid",
    "figures": ["psnr:design"], "pass": {"psnr:design": 30}})");
  const Outcome outcome = program({"--sweep", "t.json", "--session", "s.json", "--output", "out"});
  QCOMPARE(outcome.err, QByteArray());
  // Half of the units have a small error. Wilson's interval of 4 of 8.
  QVERIFY2(outcome.out.contains(
               "4 of 8 units pass (psnr:design at least 30): yield 50.0 % (21.5 … 78.5 %)"),
           outcome.out);
  const auto rows = tableOf("out/sweep.csv");
  QCOMPARE(rows[0].mid(3), (QStringList{"psnr:design", "pareto", "pass", "problem"}));
  for (const QStringList& row : rows.mid(1))
    QCOMPARE(row[5], QString(row[2] == "1e-06" ? "1" : "0"));
  QVERIFY(contentOf("out/sweep.html").contains("4 of 8 units pass"));
}

void TestTwin::mistakes_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("line");
  const auto row = [](const QStringList& arguments, const QByteArray& line) {
    QTest::newRow(line) << arguments << line;
  };
  const QStringList render{"--render", "--session", "s.json", "--output", "out"};
  const QStringList report{"--report", "--session", "s.json", "--output", "out"};
  const QStringList exported{"--export", "hogels", "--session", "s.json", "--output", "out.png"};
  row(render + QStringList{"--twin", "offset.json", "--twin", "zero.json"},
      "command line: --twin: is given 2 times; one unit is seen, and --report --against design "
      "compares more");
  row(render + QStringList{"--twin", "none.json"}, "none.json: …");
  row(render + QStringList{"--twin", "dark.json"},
      "dark.json: cameras[0].psf.light: must be \"linear\", because the twin scales or adds light");
  row(report + QStringList{"--against", "design"},
      "command line: --against design: needs a unit to compare: --twin FILE, or a session with a "
      "twin");
  row(report +
          QStringList{"--against", "design", "--twin", "offset.json", "--twin", "sub/offset.json"},
      "command line: --twin sub/offset.json: has the name of another twin: name their files "
      "differently");
  row(exported + QStringList{"--twin", "offset.json"},
      "command line: --twin: changes no content: give --for-twin too for content that is corrected "
      "for it");
  row(exported + QStringList{"--for-twin"},
      "command line: --for-twin: needs a unit: --twin FILE, or a session with a twin");
  const QStringList drawn{"--make-twin", "--session", "s.json", "--output", "u.json"};
  row(drawn, "s.json: twin.random: draws nothing: give shift or gain a sigma");
  row(drawn.mid(0, 4) + QStringList{"u.txt", "--set", "twin.random.shift.sigma=1e-5"},
      "u.txt: cannot be written: a twin's name ends in .json");
  row(drawn.mid(0, 4) + QStringList{"sub/folder.json", "--set", "twin.random.shift.sigma=1e-5"},
      "sub/folder.json: cannot be written: it is there, and is not a file");
  row(render + QStringList{"--set", "twin.maps.hogels=none.exr"}, "none.exr: …");
  row(render + QStringList{"--set", "twin.dead.rows=[1440]"},
      "s.json: twin.dead.rows: has 1440, but the hogel image has rows 0 … 959");
}

void TestTwin::mistakes() {
  QFETCH(const QStringList, arguments);
  QFETCH(const QByteArray, line);
  writeFile("sub/offset.json", "{}");
  writeFile("sub/folder.json/any", "");
  writeFile("dark.json", R"({"light": {"black": 0.1}})");
  writeFile("s.json",
            session({}).replace("linear", arguments.contains("dark.json") ? "encoded" : "linear"));
  const Outcome outcome = program(arguments);
  compareLine(outcome.err.chopped(1), "hogelscope: " + line);
  QVERIFY(!QFileInfo::exists("sub/folder.hogels.exr"));
  QCOMPARE(outcome.status, 2);
}

QTEST_GUILESS_MAIN(TestTwin)
#include "test_twin.moc"
