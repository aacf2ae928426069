// SPDX-License-Identifier: BSD-3-Clause
// Tests what the command line takes, and what it says where it does not; --help, --info.
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "cli/options.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/pictures.h"

using namespace hogelscope;

namespace {

/// What other programs may rely on.
const QStringList designedFlags{
    "render",    "session",  "output",     "format",      "masks",        "report",      "test",
    "images",    "count",    "seed",       "pack",        "explain",      "info",        "generate",
    "stability", "tradeoff", "states",     "threads",     "memory",       "set",         "quiet",
    "version",   "help",     "fail-below", "calibration", "calibrations", "make-cameras"};

std::vector<std::string> listOf(const QStringList& arguments) {
  std::vector<std::string> list;
  for (const QString& argument : arguments) list.push_back(argument.toStdString());
  return list;
}

QString refusalOf(const QStringList& arguments) {
  return errorOf([&] { (void)parseOptions(listOf(arguments)); });
}

}  // namespace

class TestCommandLine : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void helpTellsEveryFlag_data();
  void helpTellsEveryFlag();
  void helpFitsTheTerminal();
  void parameterManualIsFresh();
  void version();
  void memoryInMegabytes();
  void mistakes_data();
  void mistakes();
  void mistakesAtTheProgram_data();
  void mistakesAtTheProgram();
  void infoOfTheSample();
  void infoOfPictures();
  void infoOfAFolder();
  void infoOfNothing();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCommandLine::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestCommandLine::helpTellsEveryFlag_data() {
  QTest::addColumn<QString>("flag");
  for (const QString& flag : designedFlags) QTest::newRow(qPrintable(flag)) << flag;
}

/// Of the flags that the design knows, help has those that there are.
void TestCommandLine::helpTellsEveryFlag() {
  QFETCH(QString, flag);
  const bool isThere = !refusalOf({"--" + flag, "1"}).contains("is not a flag of ours");
  const bool isTold = QString::fromStdString(helpText("")).contains("  --" + flag + " ");
  QCOMPARE(isTold, isThere);
  if (!isThere) QSKIP("not there yet");
}

void TestCommandLine::helpFitsTheTerminal() {
  const Outcome outcome = run({"--help"}, m_folder->path());
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.out, QByteArray::fromStdString(helpText("")));
  for (const QString& line : QString::fromUtf8(outcome.out).split('\n')) {
    QVERIFY2(line.size() <= 100, qPrintable(line));
    QVERIFY2(!line.endsWith(' '), qPrintable(line));
  }
  QCOMPARE(run({"-h", "--render"}, m_folder->path()).out, outcome.out);
}

void TestCommandLine::parameterManualIsFresh() {
  const Outcome outcome = run({"--help", "parameters"}, m_folder->path());
  QCOMPARE(outcome.status, 0);
  const QString file = HOGELSCOPE_SOURCE_DIR "/resources/manual/parameters.md";
  QVERIFY2(outcome.out == contentOf(file),
           "resources/manual/parameters.md is not what the program says. Make it anew with\n"
           "  build/release/bin/hogelscope --help parameters > resources/manual/parameters.md");
}

void TestCommandLine::version() {
  const Outcome outcome = run({"--version"}, m_folder->path());
  QCOMPARE(outcome.status, 0);
  const QString line = QString::fromUtf8(outcome.out);
  QVERIFY2(QRegularExpression("^hogelscope \\d+\\.\\d+\\.\\d+\n$").match(line).hasMatch(),
           qPrintable(line));
}

void TestCommandLine::memoryInMegabytes() {
  const auto memory = [](const char* text) {
    return parseOptions({"--info", "a.png", "--memory", text}).memory;
  };
  QVERIFY(memory("2.5") == std::size_t{2500000});
  QVERIFY(memory("0") == std::size_t{1});
  QVERIFY(memory("inf") == std::size_t{1000000000000000000});
  QVERIFY(!parseOptions({"--info", "a.png"}).memory);
}

void TestCommandLine::mistakes_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* name, const QStringList& arguments, const char* line) {
    QTest::newRow(name) << arguments << QString(line);
  };
  const QStringList render{"--render", "--session", "s.json", "--output", "out"};
  row("mistyped", {"--rendr"}, "--rendr: is not a flag of ours; did you mean --render?");
  row("mistyped, with a value", {"--sesion=s.json"},
      "--sesion: is not a flag of ours; did you mean --session?");
  row("another's", {"--fail-under"},
      "--fail-under: is not a flag of ours; did you mean --fail-below?");
  row("nothing near", {"--xyzzyfoo"}, "--xyzzyfoo: is not a flag of ours; see --help");
  row("one dash", {"-r"}, "-r: is not a flag of ours; flags begin with two dashes, see --help");
  row("only dashes", {"--"}, "--: is not a flag of ours; see --help");
  row("no session", {"--render", "--output", "out"},
      "--session: is missing: name the session document");
  row("empty session", {"--render", "--session=", "--output", "out"},
      "--session: needs a value: FILE");
  row("no output", {"--render", "--session", "s.json"},
      "--output: is missing: name where the results go");
  row("no test", {"--report", "--session", "s.json", "--output", "out"},
      "--test: is missing: name a light field to compare with the session's");
  row("no session to generate", {"--generate", "scene", "--output", "g.png"},
      "--session: is missing: name the session document");
  row("no value", render + QStringList{"--states"}, "--states: needs a value: GLOB");
  row("no pattern", {"--generate"}, "--generate: needs a value: PATTERN");
  row("a flag for a value", {"--render", "--session", "--output", "out"},
      "--session: needs a value: FILE");
  row("a value too many", {"--render=1"}, "--render: takes no value");
  row("a value too many, setting", {"--quiet=yes"}, "--quiet: takes no value");
  row("two jobs", {"--render", "--report"},
      "command line: asks for two jobs at once; give one of --render, --report, "
      "--make-cameras, --generate, --pack, --tradeoff, --stability, --info");
  row("two jobs, info", {"--info", "s.json", "--generate", "scene"},
      "command line: asks for two jobs at once; give one of --render, --report, "
      "--make-cameras, --generate, --pack, --tradeoff, --stability, --info");
  row("a file alone", render + QStringList{"more.json"},
      "more.json: stands alone on the command line; a session is given as --session FILE");
  row("settings without a job", {"--session", "s.json", "--output", "out"},
      "command line: has settings but no job; give one of --render, --report, "
      "--make-cameras, --generate, --pack, --tradeoff, --stability, or only a session to open it");
  row("no threads", render + QStringList{"--threads", "0"},
      "--threads: \"0\" is not a number from 1 on");
  row("half a thread", {"--threads", "1.5"}, "--threads: \"1.5\" is not a number from 1 on");
  row("threads beyond", {"--threads", "99999999999"},
      "--threads: \"99999999999\" is not a number from 1 on");
  row("memory what", {"--memory", "4GB"}, "--memory: \"4GB\" is not a number from 0 on");
  row("memory nan", {"--memory", "nan"}, "--memory: \"nan\" is not a number from 0 on");
  row("fail-below what", {"--fail-below", "40dB"},
      "--fail-below: \"40dB\" is not a number from 0 on");
  row("fail-below nan", {"--fail-below", "nan"}, "--fail-below: \"nan\" is not a number from 0 on");
  row("format", {"--format", "jpg"}, "--format: \"jpg\" is not one of png, exr, tif");
  row("a camera set's", render + QStringList{"--count", "3"},
      "--set cameraSet.count=3: belongs to --make-cameras SET");
  row("pattern", {"--generate", "lena"},
      "--generate: \"lena\" is not one of scene, spheres, directions, hogels, checkerboard, edge, "
      "crosstalk");
  row("a pattern's", render + QStringList{"--set", "pattern.depth=1"},
      "--set pattern.depth=1: belongs to --generate PATTERN");
  row("degrade", render + QStringList{"--degrade", "jpeg:60"},
      "--degrade: belongs to --generate PATTERN");
  row("seed", render + QStringList{"--seed", "1"},
      "--seed: belongs to --make-cameras SET or --generate PATTERN");
}

void TestCommandLine::mistakes() {
  QFETCH(QStringList, arguments);
  QFETCH(QString, line);
  QCOMPARE(refusalOf(arguments), line);
}

void TestCommandLine::mistakesAtTheProgram_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("line");
  QTest::newRow("mistyped") << QStringList{"--rendr"}
                            << QByteArray("--rendr: is not a flag of ours; did you mean --render?");
  QTest::newRow("no output") << QStringList{"--render", "--session", sampleSession}
                             << QByteArray("--output: is missing: name where the results go");
  QTest::newRow("a help topic")
      << QStringList{"--help", "parametres"}
      << QByteArray("--help parametres: there is no such topic; there is --help parameters");
  QTest::newRow("the window without a display server")
      << QStringList{sampleSession}
      << QByteArray(
             "window: there is no display server (DISPLAY is not set): batch mode needs "
             "none, see --help");
}

void TestCommandLine::mistakesAtTheProgram() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, line);
  const Outcome outcome = run(arguments, m_folder->path());
  QCOMPARE(outcome.err, "hogelscope: " + line + "\n");
  QCOMPARE(outcome.out, QByteArray());
  QCOMPARE(outcome.status, 2);
  QCOMPARE(namesIn("."), QStringList());
}

void TestCommandLine::infoOfTheSample() {
  writeFile("s.json", text({.display = R"({"hogels": [4, 3], "directions": [5, 6], "fov": [30, 40],
                                           "size": [0.25, 0.5]})",
                            .cameras = R"([{"name": "é", "eye": [0.1, -2, 3], "fov": 45.5,
                                            "res": [64, 48]}])"}));
  writeGrey("scene.png", 20, 18);
  const Outcome outcome = run({"--info", "s.json"}, m_folder->path());
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.out, QByteArray("session     1 camera state(s)\n"
                                   "display     0.25×0.5 m, fov 30×40°\n"
                                   "light field scene.png\n"
                                   "hogels      4×3\n"
                                   "directions  5×6\n"
                                   "hogel image 20×18 px\n"
                                   "state       é: eye (0.1, -2, 3) m, fov 45.5°, 64×48 px, psf "
                                   "sigma 0.67 in 1 px\n"));
  QCOMPARE(outcome.status, 0);
}

void TestCommandLine::infoOfPictures() {
  writePicture("a.tif", 20, 18, [](int, int, int) { return 0.5F; }, {OIIO::TypeDesc::UINT16, 4});
  const Outcome outcome = run({"--info", "a.tif"}, m_folder->path());
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.out,
           QByteArray("picture     tiff, 20×18 px, 4 channel(s), 16 bit\n"
                      "layout      not said by the file; a session says it, with the hogels and "
                      "directions\n"));
  writeGrey("q_qs4x3a1.5.png", 20, 18);
  QCOMPARE(run({"--info", "q_qs4x3a1.5.png"}, m_folder->path()).out,
           QByteArray("picture     png, 20×18 px, 3 channel(s), 8 bit\n"
                      "layout      quilt of 4×3 views\n"
                      "hogels      5×6\n"
                      "directions  12×1\n"
                      "hogel image 60×6 px\n"));
}

void TestCommandLine::infoOfAFolder() {
  for (const char* name : {"v/001_003.png", "v/001_005.png", "v/003_003.png", "v/003_005.png"})
    writeGrey(name, 8, 6);
  QCOMPARE(run({"--info", "v"}, m_folder->path()).out, QByteArray("layout      views, 2 rows of 2\n"
                                                                  "first       001_003.png\n"
                                                                  "last        003_005.png\n"
                                                                  "hogels      8×6\n"
                                                                  "directions  2×2\n"
                                                                  "hogel image 16×12 px\n"));
}

void TestCommandLine::infoOfNothing() {
  const Outcome outcome = run({"--info", "none.png"}, m_folder->path());
  QCOMPARE(outcome.err, QByteArray("hogelscope: none.png: there is no such file\n"));
  QCOMPARE(outcome.out, QByteArray());
  QCOMPARE(outcome.status, 2);
}

QTEST_GUILESS_MAIN(TestCommandLine)
#include "test_command_line.moc"
