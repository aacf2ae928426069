// SPDX-License-Identifier: BSD-3-Clause
// Tests that a job never destroys what it reads, nor a stranger's file, nor another run's output,
// and that whatever is wrong with a path is one line and status 2.
#include <sys/stat.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

namespace {

float wave(int x, int y, int c) {
  return float((x * 7 + y * 13 + c * 31) % 64) / 63;
}

QByteArray session(const QByteArray& lightField) {
  return R"({"hogelscope": 1, "display": {"hogels": [8, 8], "directions": [4, 4]},
             "lightField": )" +
         lightField + R"(, "cameras": [{"name": "a", "eye": [0, 0, 0.5], "res": [40, 40]}]})";
}

/// Pattern by pattern, eight times as large as its session: so that two runs are at work at once.
QStringList generate(const QString& pattern) {
  return {"--generate", pattern,    "--session",
          "s.json",     "--output", "g.png",
          "--quiet",    "--set",    "display.directions=[80,80]"};
}

}  // namespace

class TestOutputs : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void inputsAreKept_data();
  void inputsAreKept();
  void reportKeepsItsViews();
  void sessionMayGrowInPlace();
  void twoRunsIntoOneFile();
  void predictableNames_data();
  void predictableNames();
  void linksAtTemporaryNames();
  void hugeJournalIsKept();
  void pathsThatThrow_data();
  void pathsThatThrow();
  void unreadableFolder();
  void everyLineIsHeard();
  void namesThatAreNotUtf8_data();
  void namesThatAreNotUtf8();
  void namesInTablesAreUtf8();

 private:
  Outcome job(const QStringList& arguments) { return run(arguments, m_folder->path()); }

  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestOutputs::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeImageFile("a.png", 32, 32, wave);
  writeImageFile("b.tif", 32, 32, wave, PictureKind{});
  writeFile("s.json", session(R"({"file": "a.png"})"));
}

void TestOutputs::inputsAreKept_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QString>("output");
  const auto row = [](const char* name, const QStringList& arguments, const QString& output) {
    QTest::newRow(name) << arguments << output;
  };
  const QString read = ", which is read: choose another name";
  row("render over the light field", {"--render", "--session", "s.json", "--output", "."},
      "./a.png: cannot be written: it is a.png" + read);
  row("by another name", {"--render", "--session", "s.json", "--output", "link"},
      "link/a.png: cannot be written: it is a.png" + read);
  row("make-cameras over the light field",
      {"--make-cameras", "random", "--session", "s.json", "--output", "a.png"},
      "a.png: cannot be written: a session's name ends in .hogelscope or .json");
  row("generate over the session",
      {"--generate", "scene", "--session", "s.json", "--output", "s.json"},
      "s.json: cannot be written: it is s.json" + read);
  row("pack over the light field",
      {"--pack", "a.png", "--session", "s.json", "--output", "hard.png"},
      "hard.png: cannot be written: it is a.png" + read);
  row("stability over its lenses",
      {"--stability", "--calibrations", "stability.csv", "--output", "."},
      "./stability.csv: cannot be written: it is stability.csv" + read);
}

void TestOutputs::inputsAreKept() {
  QFETCH(QStringList, arguments);
  QFETCH(QString, output);
  QVERIFY(QFile::link(".", "link"));
  QVERIFY(::link("a.png", "hard.png") == 0);
  writeFile("stability.csv", R"({"cameras": [{"name": "c", "size": [10, 10],
      "K": [10, 10, 5, 5], "D": [0, 0, 0, 0]}]})");
  const QByteArray content = contentOf("a.png");
  const QByteArray document = contentOf("s.json");
  const QByteArray lenses = contentOf("stability.csv");
  const Outcome outcome = job(arguments);
  QCOMPARE(outcome.err, "hogelscope: " + output.toUtf8() + "\n");
  QCOMPARE(outcome.status, 2);
  QCOMPARE(contentOf("a.png"), content);
  QCOMPARE(contentOf("s.json"), document);
  QCOMPARE(contentOf("stability.csv"), lenses);
}

void TestOutputs::reportKeepsItsViews() {
  for (const char* name : {"000_000.png", "000_001.png"})
    writeImageFile(QString("test1/") + name, 8, 8, wave);
  writeFile("v.json", QByteArray(R"({"hogelscope": 1, "display": {},
      "lightField": {"file": "test1", "layout": "views"},
      "cameras": [{"name": "000_001", "eye": [0, 0, 0.5], "res": [40, 40]}]})"));
  const QByteArray content = contentOf("test1/000_001.png");
  const Outcome outcome =
      job({"--report", "--session", "v.json", "--test", "v.json", "--output", ".", "--images"});
  QCOMPARE(outcome.err, QByteArray("hogelscope: ./test1/000_001.png: cannot be written: it is "
                                   "test1/000_001.png, which is read: choose another name\n"));
  QCOMPARE(outcome.status, 2);
  QCOMPARE(contentOf("test1/000_001.png"), content);
}

void TestOutputs::sessionMayGrowInPlace() {
  QCOMPARE(
      job({"--make-cameras", "random", "--count", "2", "--session", "s.json", "--output", "s.json"})
          .status,
      0);
  QVERIFY(contentOf("s.json").contains("random-"));
}

void TestOutputs::twoRunsIntoOneFile() {
  QList<QByteArray> wholes;
  for (const char* pattern : {"scene", "spheres"}) {
    QCOMPARE(job(generate(pattern)).status, 0);
    wholes << contentOf("g.png");
  }
  QFile::remove("g.png");
  QProcess first;
  QProcess second;
  start(first, generate("scene"), m_folder->path());
  start(second, generate("spheres"), m_folder->path());
  QVERIFY(first.waitForFinished(-1) && second.waitForFinished());
  QCOMPARE(first.exitCode(), 0);
  QCOMPARE(second.exitCode(), 0);
  QVERIFY(wholes.contains(contentOf("g.png")));
  QCOMPARE(namesIn("."), (QStringList{"a.png", "b.tif", "g.png", "s.json"}));
}

void TestOutputs::predictableNames_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("isLink");
  for (const char* name : {"report.journal", "report.panel1"})
    for (const bool isLink : {false, true})
      QTest::addRow("%s, %s", name, isLink ? "a link" : "a file") << QString(name) << isLink;
}

void TestOutputs::predictableNames() {
  QFETCH(QString, name);
  QFETCH(bool, isLink);
  const QString diary = isLink ? "diary" : "out/" + name;
  QVERIFY(QDir().mkdir("out"));
  writeFile(diary, "my diary");
  if (isLink) QVERIFY(QFile::link("../diary", "out/" + name));
  const Outcome outcome =
      job({"--report", "--session", "s.json", "--test", "b.tif", "--output", "out"});
  QCOMPARE(outcome.err,
           "hogelscope: out/" + name.toUtf8() +
               ": cannot be written: it is there, and was not written by hogelscope: move it "
               "away\n");
  QCOMPARE(outcome.status, 2);
  QCOMPARE(contentOf(diary), QByteArray("my diary"));
  QVERIFY(QFileInfo::exists("out/" + name));
}

void TestOutputs::linksAtTemporaryNames() {
  QVERIFY(QDir().mkdir("out"));
  writeFile("diary", "my diary");
  QVERIFY(QFile::link("../diary", "out/.a.part.png"));
  QVERIFY(QFile::link("diary", "store.tif.part"));
  QCOMPARE(job({"--render", "--session", "s.json", "--output", "out"}).status, 0);
  QCOMPARE(namesIn("out"), (QStringList{".a.part.png", "a.png"}));
  QCOMPARE(job({"--pack", "a.png", "--session", "s.json", "--output", "store.tif"}).status, 2);
  QCOMPARE(contentOf("diary"), QByteArray("my diary"));
}

/// 360 000 rows and more.
void TestOutputs::hugeJournalIsKept() {
  const QByteArray foreign(68000000, 'x');
  writeFile("out/report.journal", foreign);
  const QStringList report{"--report", "--session", "s.json", "--test", "b.tif", "--output", "out"};
  QCOMPARE(job(report).status, 2);
  QCOMPARE(contentOf("out/report.journal").size(), foreign.size());
  writeFile("out/report.journal",
            R"({"hogelscope report":1,"key":"other"})" + ("\n" + foreign) + "\n");
  QCOMPARE(job(report).status, 0);
}

void TestOutputs::pathsThatThrow_data() {
  QTest::addColumn<QStringList>("arguments");
  const QStringList render{"--render", "--session", "s.json", "--output", "out"};
  QTest::newRow("info") << QStringList{"--info", "loop"};
  QTest::newRow("info, a long name") << QStringList{"--info", QString(300, 'x')};
  QTest::newRow("info, below a long name") << QStringList{"--info", QString(300, 'x') + "/a.png"};
  QTest::newRow("pack") << QStringList{"--pack", "loop", "--output", "p.tif"};
  QTest::newRow("pack to") << QStringList{"--pack", "a.png",    "--session",
                                          "s.json", "--output", "loop/"};
  QTest::newRow("session") << QStringList{"--render", "--session", "loop", "--output", "out"};
  QTest::newRow("render to") << QStringList{"--render", "--session", "s.json", "--output",
                                            "loop/out"};
  QTest::newRow("test") << QStringList{"--report", "--session", "s.json", "--test",
                                       "loop",     "--output",  "out"};
  QTest::newRow("views") << render + QStringList{"--set", "lightField.layout=views", "--set",
                                                 "lightField.file=loop"};
  QTest::newRow("cameras") << QStringList{"--make-cameras", "loop.json", "--session",
                                          "s.json",         "--output",  "out.json"};
  QTest::newRow("calibration") << render + QStringList{"--calibration", "loop"};
}

void TestOutputs::pathsThatThrow() {
  QFETCH(QStringList, arguments);
  QVERIFY(QFile::link("loop", "loop"));
  const Outcome outcome = job(arguments);
  QVERIFY2(outcome.err.startsWith("hogelscope: ") && outcome.err.count('\n') == 1, outcome.err);
  QVERIFY2(outcome.status == 2, outcome.err);
}

void TestOutputs::unreadableFolder() {
  QVERIFY(QDir().mkdir("closed"));
  QCOMPARE(::chmod("closed", 0), 0);
  QCOMPARE(::chmod(".", 0755), 0);
  QProcess process;
  process.setChildProcessModifier([] {
    constexpr uid_t nobody = 65534;  // root may read every folder
    if (::geteuid() == 0 && ::setuid(nobody) != 0) ::_exit(9);
  });
  start(process, {"--info", "closed"}, m_folder->path());
  process.waitForFinished(-1);
  QCOMPARE(::chmod("closed", 0700), 0);
  if (process.error() == QProcess::FailedToStart) QSKIP("nobody may not run the program here");
  QCOMPARE(process.readAllStandardError(),
           QByteArray("hogelscope: closed: cannot be read: Permission denied\n"));
  QCOMPARE(process.exitCode(), 2);
}

/// Two light fields are read side by side, on two threads; what is said afterwards is heard.
void TestOutputs::everyLineIsHeard() {
  writeImageFile("r.tif", 640, 640, wave, PictureKind{});
  writeImageFile(
      "t.tif", 640, 640, [](int x, int y, int c) { return 0.9F * wave(x, y, c); }, PictureKind{});
  writeFile("s.json", session(R"({"file": "r.tif"})"));
  for (int k = 0; k < 3; ++k) {
    const Outcome outcome =
        job({"--report", "--session", "s.json", "--test", "t.tif", "--output", "out", "--memory",
             "1", "--fail-below", "90", "--set", "display.directions=[80,80]"});
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.err.contains(" dB over what is seen is below 90\n"), outcome.err);
  }
}

void TestOutputs::namesThatAreNotUtf8_data() {
  QTest::addColumn<QByteArray>("command");
  const auto row = [](const char* name, const QByteArray& command) {
    QTest::newRow(name) << command;
  };
  row("a twin", "--make-twin --session s.json --twin u.json --output \377\377.json");
  row("a unit", "--report --against design --session s.json --twin \377.json --output out");
  row("a test", "--report --session s.json --test \377.png --output out");
  row("a session", "--render --session \377/s.json --output out --save-session k.json");
  row("a fit", "--depth --session \377/s.json --output out --fit k.json");
}

/// What would stand in a document or a table is refused before anything is written. A shell runs
/// the program, since Qt's names are UTF-8.
void TestOutputs::namesThatAreNotUtf8() {
  QFETCH(QByteArray, command);
  QVERIFY(::mkdir("\377", 0777) == 0);
  writeFile("u.json", R"({"random": {"seed": 1, "shift": {"sigma": 0.0001}}})");
  const auto copy = [](const char* from, const QByteArray& to) {
    QVERIFY(::link(from, to.constData()) == 0);
  };
  copy("u.json", "\377.json");
  copy("a.png", "\377.png");
  copy("a.png", "\377/a.png");
  copy("s.json", "\377/s.json");
  const QStringList before = namesIn(".");
  writeFile("run.sh", QByteArray(HOGELSCOPE_PROGRAM) + " " + command + "\n");
  QProcess shell;
  shell.setProcessEnvironment(withoutDisplay());
  shell.start("sh", {"run.sh"});
  const Outcome outcome = ended(shell);
  QFile::remove("run.sh");
  QCOMPARE(outcome.status, 2);
  QVERIFY2(outcome.err.contains("not UTF-8") && outcome.err.count('\n') == 1, outcome.err);
  QStringList after = namesIn(".");
  after.removeAll("out");  // an empty folder may be there
  QCOMPARE(after, before);
  QVERIFY(!QFileInfo::exists("out") || namesIn("out").isEmpty());
}

void TestOutputs::namesInTablesAreUtf8() {
  writeFile("run.sh", QByteArray("mv c.yml '\377.yml'\n") + HOGELSCOPE_PROGRAM +
                          " --stability --calibrations '\377.yml' --output out --quiet\n");
  writeFile("c.yml", R"(%YAML:1.0
camera_matrix: !!opencv-matrix {rows: 3, cols: 3, dt: d, data: [10, 0, 5, 0, 10, 5, 0, 0, 1]}
distortion_coefficients: !!opencv-matrix {rows: 5, cols: 1, dt: d, data: [0, 0, 0, 0, 0]}
)");
  QProcess shell;
  shell.setProcessEnvironment(withoutDisplay());
  shell.start("sh", {"run.sh"});
  const Outcome outcome = ended(shell);
  QVERIFY2(outcome.status == 0, outcome.err);
  QVERIFY(contentOf("out/stability.csv").contains("\\xff"));
}

QTEST_GUILESS_MAIN(TestOutputs)
#include "test_outputs.moc"
