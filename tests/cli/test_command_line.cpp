// SPDX-License-Identifier: BSD-3-Clause
// Tests what the command line takes, and what it says where it does not; --help, --info.
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "cli/command_line.h"
#include "cli/help.h"
#include "tests/cli/program.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

/// What other programs may rely on.
const QStringList designedFlags{
    "render",    "session",  "output",     "format",      "masks",        "report",      "test",
    "images",    "count",    "seed",       "pack",        "explain",      "info",        "generate",
    "stability", "tradeoff", "states",     "threads",     "memory",       "set",         "quiet",
    "version",   "help",     "fail-below", "calibration", "calibrations", "make-cameras"};

/// Of pictures of one colour.
const char* const noOrder =
    "order       rows top-down, columns left-right: unknown\n"
    "found by    nothing in the views has enough structure to follow\n";

std::vector<std::string> listOf(const QStringList& arguments) {
  std::vector<std::string> list;
  for (const QString& argument : arguments) list.push_back(argument.toStdString());
  return list;
}

QString refusalOf(const QStringList& arguments) {
  return errorOf([&] { (void)parseCommandLine(listOf(arguments)); });
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
  void memoryInMegabytes_data();
  void memoryInMegabytes();
  void mistakes_data();
  void mistakes();
  void mistakesAtTheProgram_data();
  void mistakesAtTheProgram();
  void infoOfTheSample();
  void infoOfAMesh();
  void infoOfAMeshOfAnySize();
  void memoryOfAMesh();
  void cutsOfAMesh();
  void infoOfALiveSession();
  void infoOfPictures();
  void infoOfAFolder();
  void infoHearsSettings_data();
  void infoHearsSettings();
  void infoOfALensSheet();
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
  const bool isThere = !refusalOf({"--" + flag, "1"}).contains("unknown option");
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

void TestCommandLine::memoryInMegabytes_data() {
  QTest::addColumn<QString>("given");
  QTest::addColumn<double>("megabytes");  ///< 0: refused
  QTest::newRow("a part") << "2.5" << 2.5;
  QTest::newRow("least") << "0.001" << 0.001;
  QTest::newRow("most") << "1e9" << 1e9;
  for (const char* bad : {"0", "-1", "1e-9", "1e10", "1e300", "inf", "nan", "-nan", "4GB", "1e999"})
    QTest::newRow(bad) << bad << 0.0;
}

void TestCommandLine::memoryInMegabytes() {
  QFETCH(QString, given);
  QFETCH(double, megabytes);
  const QStringList arguments{"--pack", "a.png", "--output", "b", "--memory", given};
  if (megabytes > 0)
    QCOMPARE(*parseCommandLine(listOf(arguments)).number("memory"), megabytes);
  else
    QCOMPARE(refusalOf(arguments),
             "--memory: \"" + given + "\" is not a number from 0.001 to 1e+09");
}

void TestCommandLine::mistakes_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* name, const QStringList& arguments, const char* line) {
    QTest::newRow(name) << arguments << QString(line);
  };
  const QStringList render{"--render", "--session", "s.json", "--output", "out"};
  row("mistyped", {"--rendr"}, "--rendr: unknown option; did you mean --render?");
  row("mistyped, with a value", {"--sesion=s.json"},
      "--sesion: unknown option; did you mean --session?");
  row("another's", {"--fail-under"}, "--fail-under: unknown option; did you mean --fail-below?");
  row("nothing near", {"--xyzzyfoo"}, "--xyzzyfoo: unknown option; see --help");
  row("one dash", {"-r"}, "-r: unknown option; options begin with two dashes, see --help");
  row("only dashes", {"--"}, "--: unknown option; see --help");
  row("no session", {"--render", "--output", "out"},
      "--session: is missing; --render needs --session FILE, see --help render");
  row("empty session", {"--render", "--session=", "--output", "out"},
      "--session: needs a value: FILE");
  row("no test", {"--report", "--session", "s.json", "--output", "out"},
      "--test: is missing; --report needs --test LF, see --help report");
  row("no value", render + QStringList{"--states"}, "--states: needs a value: GLOB");
  row("no pattern", {"--generate"}, "--generate: needs a value: PATTERN");
  row("an option for a value", {"--render", "--session", "--output", "out"},
      "--session: needs a value: FILE");
  row("a value too many", {"--render=1"}, "--render: takes no value");
  row("a value too many, setting", {"--quiet=yes"}, "--quiet: takes no value");
  row("two jobs", {"--render", "--report"},
      "--report: is a second job beside --render; give one of them");
  row("two jobs, info", {"--info", "s.json", "--generate", "scene"},
      "--generate: is a second job beside --info; give one of them");
  row("a file alone", render + QStringList{"more.json"},
      "more.json: unexpected argument of --render; see --help render");
  row("a file in place of --session", {"--render", "data/table 1.json", "--output", "out"},
      "data/table 1.json: is no option: --render reads it if you give --session 'data/table "
      "1.json'; "
      "see --help render");
  row("two files for --info", {"--info", "a.png", "b.png"},
      "b.png: unexpected argument of --info; see --help info");
  row("two topics", {"--help", "render", "report"},
      "render: unexpected argument of --help; see --help help");
  row("two outputs", render + QStringList{"--output", "other"},
      "--output other: is given twice, before as out");
  row("twice the same", render + QStringList{"--masks", "--masks"}, "--masks: is given twice");
  row("twice the same job", {"--pack", "a.png", "--pack", "b.png", "--output", "c.tif"},
      "--pack: is a second job beside --pack; give one of them");
  row("twice the same test",
      {"--report", "--session", "s.json", "--output", "out", "--test", "a.png", "--test", "b.png",
       "--test", "a.png"},
      "--test a.png: is given twice");
  row("a parameter twice",
      render + QStringList{"--set", "psf.sigma=1", "--set", "camera.fov=3", "--set", "psf.sigma=2"},
      "--set psf.sigma=2: sets psf.sigma a second time");
  row("a parameter by two ways",
      {"--make-cameras", "random", "--session", "s.json", "--output", "t.json", "--count", "3",
       "--set", "cameraSet.count=4"},
      "--set cameraSet.count=4: sets cameraSet.count a second time");
  row("settings without a job", {"--fail-below", "3"},
      "--fail-below: belongs to --report; without a job the window opens");
  const QString number = "\" is not a number from ";
  for (const char* bad : {"0", "-1", "1.5", "99999999999", "nan"})
    row(bad, render + QStringList{"--threads", bad},
        qPrintable("--threads: \"" + (bad + number) + "1 on"));
  const QStringList report{"--report", "--session", "s.json", "--output", "out", "--test", "t.png"};
  for (const char* bad : {"40dB", "nan", "-1"})
    row(qPrintable(QString("fail-below ") + bad), report + QStringList{"--fail-below", bad},
        qPrintable("--fail-below: \"" + (bad + number) + "0 on"));
  row("format", render + QStringList{"--format", "jpg"},
      "--format: \"jpg\" is not one of png, exr, tif");
  row("a camera set's", render + QStringList{"--set", "cameraRegion.region=box"},
      "--set cameraRegion.region=box: belongs to --make-cameras");
  row("a pattern's", render + QStringList{"--set", "pattern.depth=1"},
      "--set pattern.depth=1: belongs to --generate");
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
                            << QByteArray("--rendr: unknown option; did you mean --render?");
  QTest::newRow("no output")
      << QStringList{"--render", "--session", sampleSession}
      << QByteArray("--output: is missing; --render needs --output PATH, see --help render");
  QTest::newRow("a help topic")
      << QStringList{"--help", "parametres"}
      << QByteArray("--help parametres: there is no such topic; did you mean --help parameters?");
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
                                   "sigma 0.67 in 1 px\n") +
                            noOrder);
  QCOMPARE(outcome.status, 0);
}

/// Of 0.1125 m, half of its panel's nine tenths, 0.05 of 0.559 m are lost to what stands before it.
void TestCommandLine::infoOfAMesh() {
  writeFile("a.obj", "v -1 0 1\nv 1 0 1\nv -1 1 -1\nf 1 2 3\nl 1 2\n");
  const Outcome outcome = run({"--info", "a.obj"}, m_folder->path());
  QCOMPARE(outcome.err, QByteArray());
  for (const char* line :
       {"source      mesh\n", "  file        a.obj\n", "  position    (0, -0.1025, -0.1549) m\n",
        "  scale       0.2049\n", "  samples     1\n", "triangles   1\n",
        "depths      -0.3598 … 0.05 m\n", "note        Its lines l are not shown.\n",
        "display     0.5×0.25 m, ", "hogels      256×128\n", "directions  100×100\n"})
    QVERIFY2(outcome.out.contains(line), outcome.out.constData());
  QVERIFY(!outcome.out.contains("warning"));
}

void TestCommandLine::memoryOfAMesh() {
  writeFile("a.obj",
            QByteArray("v -1 0 1\nv 1 0 1\nv 1 1 1\n") + QByteArray("f 1 2 3\n").repeated(9));
  const Outcome outcome =
      run({"--render", "--session", "a.obj", "--output", "none", "--memory", "0.001"},
          m_folder->path());
  QVERIFY2(outcome.err.contains(" of memory or more: 1 kB are allowed: use a smaller mesh"),
           outcome.err.constData());
  QCOMPARE(outcome.err.count('\n'), 1);
  QCOMPARE(outcome.status, 2);
}

/// Nearer to the eye it reaches beyond the panel. A session says what its author wants.
void TestCommandLine::cutsOfAMesh() {
  writeFile("a.obj", "v -1 0 1\nv 1 0 1\nv 1 1 1\nv -1 1 1\nf 1 2 3 4\n");
  const QStringList nearer{"--set", "lightField.mesh.position=[0,-0.1125,0]"};
  const QByteArray line = "View: the panel cuts what stands before it (left, right, upper, lower)";
  const Outcome info = run(QStringList{"--info", "a.obj"} + nearer, m_folder->path());
  QVERIFY2(info.out.contains("warning     " + line), info.out.constData());
  const QStringList job{"--render", "--output", "out", "--set", "camera.res=[20,20]", "--session"};
  const QStringList made{"a.obj", "--save-session", "s.json"};
  const Outcome mesh = run(job + made + nearer, m_folder->path());
  QVERIFY2(mesh.err.contains("hogelscope: a.obj: warning: " + line), mesh.err.constData());
  QVERIFY(!run(job + QStringList{"s.json"}, m_folder->path()).err.contains("warning"));
}

/// No session has a scale that could be made smaller.
void TestCommandLine::infoOfAMeshOfAnySize() {
  writeFile("large.obj", "v 0 0 0\nv 1e7 0 0\nv 0 1e7 0\nf 1 2 3\n");
  writeFile("huge.obj", "v 0 0 0\nv 1e30 0 0\nv 0 1e30 0\nf 1 2 3\n");
  for (const char* file : {"large.obj", "huge.obj"}) {
    const Outcome outcome = run({"--info", file}, m_folder->path());
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.err.contains("too large") && !outcome.err.contains("smaller"),
             outcome.err.constData());
  }
}

void TestCommandLine::infoOfALiveSession() {
  writeFile("s.json", text({.lightField = R"({"layout": "live", "source": "scene",
                                              "scene": {"samples": 8}})"}));
  const Outcome outcome = run({"--info", "s.json"}, m_folder->path());
  QCOMPARE(outcome.err, QByteArray());
  for (const char* line : {"light field scene\n", "source      scene\n", "  samples     8\n",
                           "  depth       (-10, 10) m\n", "depths      "})
    QVERIFY2(outcome.out.contains(line), outcome.out.constData());
}

void TestCommandLine::infoOfPictures() {
  writeImageFile("a.tif", 20, 18, [](int, int, int) { return 0.5F; }, {PictureType::UInt16, 4});
  const Outcome outcome = run({"--info", "a.tif"}, m_folder->path());
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(
      outcome.out,
      QByteArray("picture     tiff, 20×18 px, 4 channel(s), 16 bit\n"
                 "layout      not said by the file, in which no hogels, tiles or lenslets were "
                 "found; for hogels: --set display.hogels=[nx,ny] --set "
                 "display.directions=[du,dv]; for a quilt: --set lightField.layout=quilt "
                 "--set lightField.columns=N --set lightField.rows=N; for a mosaic: --set "
                 "lightField.layout=mosaic --set display.directions=[du,dv]; for lenslets: "
                 "--set lightField.layout=lenslets\n"));
  writeGrey("q_qs4x3a1.5.png", 20, 18);
  QCOMPARE(run({"--info", "q_qs4x3a1.5.png"}, m_folder->path()).out,
           QByteArray("picture     png, 20×18 px, 3 channel(s), 8 bit\n"
                      "layout      quilt of 4×3 views\n"
                      "hogels      5×6\n"
                      "directions  12×1\n"
                      "hogel image 60×6 px\n") +
               noOrder);
}

void TestCommandLine::infoOfAFolder() {
  for (const char* name : {"v/001_003.png", "v/001_005.png", "v/003_003.png", "v/003_005.png"})
    writeGrey(name, 8, 6);
  QCOMPARE(run({"--info", "v"}, m_folder->path()).out,
           QByteArray("layout      views, 2 rows of 2\n"
                      "names       RRR_CCC\n"
                      "first       001_003.png\n"
                      "last        003_005.png\n"
                      "pictures    png, 3 channel(s), 8 bit\n"
                      "hogels      8×6\n"
                      "directions  2×2\n"
                      "hogel image 16×12 px\n") +
               noOrder + "shear       0, 0 px/view\n");
}

void TestCommandLine::infoHearsSettings_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QStringList>("settings");
  QTest::addColumn<QByteArray>("said");  ///< in the output, or the error's line
  QTest::addColumn<int>("status");
  const auto row = [](const char* name, const char* file, const QStringList& settings,
                      const char* said, int status) {
    QTest::newRow(name) << file << settings << QByteArray(said) << status;
  };
  row("a session's camera", "s.json", {"camera.fov=33"}, "fov 33°, 600×600 px", 0);
  row("a session's light field", "s.json", {"lightField.file=none.png"}, "none.png: there is no",
      2);
  row("a session's unknown one", "s.json", {"psf.sigmma=1"},
      "s.json: cameras[0].psf.sigmma: is not known here; did you mean \"sigma\"?", 2);
  row("a section of nobody", "s.json", {"lens.k1=1"},
      "s.json: override lens.k1=1: there is no section \"lens\"", 2);
  row("a hogel image", "scene.png", {"display.hogels=[4,3]", "display.directions=[5,6]"},
      "layout      hogels\nhogels      4×3\ndirections  5×6\n", 0);
  row("of another size", "scene.png", {"display.hogels=[4,3]", "display.directions=[5,5]"},
      "scene.png: size: is 20×18 px, but", 2);
  row("half of it", "scene.png", {"display.hogels=[4,3]"},
      "scene.png: display.directions: is missing", 2);
  row("a quilt", "scene.png",
      {"lightField.layout=quilt", "lightField.columns=5", "lightField.rows=3"},
      "layout      quilt of 5×3 views\nhogels      4×6\n", 0);
  row("a mosaic", "scene.png", {"lightField.layout=mosaic", "display.directions=[5,3]"},
      "layout      mosaic, 3 rows of 5 views\nhogels      4×6\ndirections  5×3\n", 0);
  row("a mosaic of nobody knows how many", "scene.png", {"lightField.layout=mosaic"},
      "scene.png: display.directions: is not given: how many views", 2);
  row("a folder", "v", {"lightField.pattern=a CC RR.png"}, "directions  2×1\n", 0);
  row("a folder's unknown one", "v", {"lightField.patern=a"},
      "v: lightField.patern: is not known here; did you mean \"pattern\"?", 2);
  row("a light field has no camera", "v", {"camera.fov=3"},
      "v: --set camera.fov=3: does not apply to a light field; lightField and display do", 2);
}

void TestCommandLine::infoHearsSettings() {
  QFETCH(QString, file);
  QFETCH(QStringList, settings);
  QFETCH(QByteArray, said);
  QFETCH(int, status);
  writeFile("s.json", text());
  writeGrey("scene.png", 20, 18);
  for (const char* name : {"v/a 1 1.png", "v/a 2 1.png"}) writeGrey(name, 4, 3);
  QStringList arguments{"--info", file};
  for (const QString& setting : settings) arguments << "--set" << setting;
  const Outcome outcome = run(arguments, m_folder->path());
  QCOMPARE(outcome.status, status);
  const QByteArray& told = status == 0 ? outcome.out : outcome.err;
  QVERIFY2(told.contains(said), told);
  QCOMPARE(outcome.err.count('\n'), status == 0 ? 0 : 1);
}

void TestCommandLine::infoOfALensSheet() {
  writeFile("visual.json", R"({"serial": "unit\u001b7", "pitch": {"value": 50.0}, "slope": -6,
    "center": 0.25, "viewCone": 40, "DPI": 254, "screenW": 3840, "screenH": 2160, "invView": 0})");
  const Outcome outcome = run({"--info", "visual.json"}, m_folder->path());
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(
      outcome.out,
      QByteArray(
          R"(lens sheet  unit\x1b7)"
          "\n"
          "panel       3840×2160 px of 0.1000 mm, 0.3840×0.2160 m\n"
          "sub-pixels  upright stripes of red, green, blue\n"
          "lenses      745.62 across, 0.5150 mm (5.150 px) apart along a row, 9.462° from "
          "upright, the top to the right\n"
          "cone        40°: 0.728 m wide at 1 m; taken for the lenses', whose pixels "
          "are then 0.7075 mm of air behind them\n"
          "seen        at 0.6 m: views repeat every 0.437 m; 14.4 % of head positions have the "
          "flip between their eyes (63 mm apart)\n"
          "views       of 48: 109.9 pass in a metre, 1.00 (rms) mix in one place\n"
          "sharp       with 48 views 10.9 mm in front and 8.3 mm behind, with any number 11.4 "
          "mm in front and 8.6 mm behind\n"
          "warning     invView is 0, which is ignored: views go from left to right\n"));
  QCOMPARE(run({"--info", "visual.json", "--json"}, m_folder->path()).err,
           QByteArray("hogelscope: command line: --json: is for a light field, not for a lens "
                      "sheet's calibration\n"));
}

void TestCommandLine::infoOfNothing() {
  const Outcome outcome = run({"--info", "none.png"}, m_folder->path());
  QCOMPARE(outcome.err, QByteArray("hogelscope: none.png: there is no such file\n"));
  QCOMPARE(outcome.out, QByteArray());
  QCOMPARE(outcome.status, 2);
}

QTEST_GUILESS_MAIN(TestCommandLine)
#include "test_command_line.moc"
