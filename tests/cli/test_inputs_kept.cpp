// SPDX-License-Identifier: BSD-3-Clause
// Makes each file that a job writes a link to each file that it reads: no input changes. Outputs
// are found by running the job, so that a new one is tried without a word here. The environment
// variable HOGELSCOPE_ALL_PAIRS has all pairs tried; without it each output and each input is tried
// once. Changes each file that a long run reads before it goes on: it begins anew.
#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "cli/flags.h"
#include "cli/jobs.h"
#include "tests/cli/program.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

float wave(int x, int y, int c) {
  return float((x * 7 + y * 13 + c * 31) % 64) / 63;
}

QByteArray session(const QByteArray& display, const QByteArray& lightField,
                   const QByteArray& more = {}) {
  return R"({"hogelscope": 1, "display": {)" + display + R"(}, "lightField": {)" + lightField +
         "}, " + more +
         R"("cameras": [{"name": "s0", "eye": [0, 0, 0.4], "res": [12, 12],
                         "distortion": {"k1": -0.1}, "psf": {"sigma": 0.8, "windowSize": 3}},
                        {"name": "s1", "eye": [0.01, 0, 0.4], "res": [12, 12]}]})";
}

const QByteArray hogels = R"("size": [0.2, 0.2], "hogels": [8, 8], "directions": [4, 4])";

/// Writes a glTF of one triangle whose points are in room.bin.
void writeMesh() {
  const std::array<float, 9> points{-0.05F, -0.05F, 0, 0.05F, -0.05F, 0, 0, 0.05F, 0};
  writeFile("room.bin", QByteArray(reinterpret_cast<const char*>(points.data()), sizeof points));
  writeFile("room.gltf",
            R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
      "bufferViews": [{"buffer": 0, "byteLength": 36}],
      "buffers": [{"byteLength": 36, "uri": "room.bin"}]})");
}

void writeCalibration(const QString& file) {
  writeFile(file, R"({"image_width": 12, "image_height": 12,
      "camera_matrix": {"type_id": "opencv-matrix", "rows": 3, "cols": 3, "dt": "d",
                        "data": [12, 0, 5.5, 0, 12, 5.5, 0, 0, 1]},
      "distortion_coefficients": {"type_id": "opencv-matrix", "rows": 5, "cols": 1, "dt": "d",
                                  "data": [-0.1, 0.01, 0, 0, 0]}})");
}

const QByteArray sheetCalibration =
    R"({"pitch": 52.58, "slope": -7.2, "center": 0.1, "viewCone": 40, "DPI": 324,
        "screenW": 64, "screenH": 64, "invView": 1})";

/// Writes all inputs into the current folder.
void writeInputs() {
  writeImageFile("a.png", 32, 32, wave);
  writeImageFile("b.png", 32, 32, [](int x, int y, int c) { return wave(x + 1, y, c); });
  for (const char* name : {"000_000", "000_001", "001_000", "001_001"})
    writeImageFile(QString("v/%1.png").arg(name), 8, 8, wave);
  writeImageFile("quilt_qs2x1a1.png", 64, 32, wave);
  for (const char* state : {"s0", "s1"})
    writeImageFile(QString("wanted/%1.png").arg(state), 12, 12, wave);
  writeMesh();
  writeFile("lens.csv", "direction,angle\n-0.5,-30\n0.5,30\n");
  QByteArray directions = "u,v,x,y\n";
  for (int u = 0; u < 4; ++u)
    for (int v = 0; v < 4; ++v)
      directions += QByteArray::number(u) + "," + QByteArray::number(v) + "," +
                    QByteArray::number((u - 1.5) * 0.28) + "," +
                    QByteArray::number((1.5 - v) * 0.28) + "\n";
  writeFile("directions.csv", directions);
  writeFile("maps.json", R"({"maps": {"directions": "directions.csv"}})");
  for (const char* unit : {"unit.json", "other.json"})
    writeFile(unit, R"({"lensArray": {"offset": [0.0001, 0]},
                        "random": {"seed": 1, "shift": {"sigma": 0.0001}}})");
  writeCalibration("camera.json");
  writeFile("visual.json", sheetCalibration);
  writeFile("weave.json", sheetCalibration);
  writeFile("trace.csv", "time,x,y,z\n0,0,0,0.4\n1,0.01,0,0.4\n2,0.02,0,0.4\n");
  writeFile("set.json", R"({"hogelscopeCameras": 1, "trace": {"file": "trace.csv"}})");
  writeFile("table.json", R"({"parameters": {"lightField.file": ["b.png"]},
                              "figures": ["psnr:design"], "pareto": {"psnr:design": "max"}})");
  for (const QByteArray viewer : {"first", "second"})
    writeFile(viewer + ".json", R"({"hogelscope votes": 1, "viewer": ")" + viewer + R"(",
        "trials": [{"state": "a", "vote": 3, "shown": ["a", "b"]}]})");
  writeFile("s.json", session(hogels + R"(, "lens": "plugin", "lensSource": "measured-lens",
                                       "measured-lens": {"file": "lens.csv"})",
                              R"("file": "a.png")", R"("twin": "maps.json", )"));
  writeFile("plain.json", session(hogels, R"("file": "a.png")"));
  writeFile("test.json", session(hogels, R"("file": "b.png")"));
  writeFile("campaign.json", R"({"scenes": {"one": "plain.json"}, "rates": "rates.csv",
                                 "tests": [{"name": "b", "file": "test.json"}]})");
  writeFile("rates.csv", "scene,test,bits\none,b,0.5\n");
  writeFile("views.json", session(R"("size": [0.2, 0.2])", R"("file": "v", "layout": "views")"));
  writeFile("mesh.json", session(hogels, R"("layout": "live", "source": "mesh",
      "viewingDistance": 0.6, "mesh": {"file": "room.gltf"})"));
  writeFile("sheet.json",
            session(R"("kind": "sheet", "calibration": "visual.json")",
                    R"("file": "quilt_qs2x1a1.png", "layout": "quilt",
                                     "calibration": "weave.json")")
                .replace(R"("psf": {"sigma": 0.8, "windowSize": 3})", R"("psf": {})"));
}

/// A command line, and the files that it reads.
struct Case {
  QString name;
  QString job;
  QStringList arguments;  ///< with "out" as --output where it is a folder, or OUT.ending
  QStringList inputs;
  bool isSlow = false;  ///< no pairs are tried
};

const QStringList ofSession{"s.json", "a.png", "lens.csv", "maps.json", "directions.csv"};
const QStringList ofMesh{"mesh.json", "room.gltf", "room.bin"};
const QStringList ofViews{"views.json", "v/000_000.png", "v/001_001.png"};
const QStringList ofSheet{"sheet.json", "visual.json", "weave.json", "quilt_qs2x1a1.png"};

std::vector<Case> cases() {
  const QStringList kept{"--save-session", "kept.json"};
  return {
      {"render", "render",
       QStringList{"--render", "--session", "s.json", "--output", "out", "--masks", "--calibration",
                   "camera.json"} +
           kept,
       ofSession + QStringList{"camera.json"}},
      {"render undistorted",
       "render",
       {"--render", "--session", "plain.json", "--output", "out", "--undistort", "--twin",
        "unit.json"},
       {"plain.json", "a.png", "unit.json"}},
      {"render focus stack",
       "render",
       {"--render", "--session", "mesh.json", "--output", "out", "--focus-stack", "2", "--set",
        "pupil.diameter=0.004", "--set", "pupil.samples=2"},
       ofMesh},
      {"report", "report",
       QStringList{"--report", "--session", "s.json", "--test", "test.json", "--output", "out",
                   "--images", "--calibration", "camera.json"} +
           kept,
       ofSession + QStringList{"camera.json", "test.json", "b.png"}},
      {"campaign",
       "report",
       {"--report", "--campaign", "campaign.json", "--output", "out"},
       {"campaign.json", "rates.csv", "plain.json", "a.png", "test.json", "b.png"}},
      {"report of units",
       "report",
       {"--report", "--against", "design", "--session", "plain.json", "--twin", "unit.json",
        "--twin", "other.json", "--output", "out"},
       {"plain.json", "a.png", "unit.json", "other.json"}},
      {"cameras",
       "make-cameras",
       {"--make-cameras", "set.json", "--session", "s.json", "--output", "OUT.json",
        "--calibration", "camera.json"},
       ofSession.mid(1) + QStringList{"camera.json", "set.json", "trace.csv"}},
      {"cameras of a mesh",
       "make-cameras",
       {"--make-cameras", "trace.csv", "--session", "mesh.json", "--output", "OUT.json"},
       ofMesh.mid(1) + QStringList{"trace.csv"}},
      {"twin",
       "make-twin",
       {"--make-twin", "--session", "plain.json", "--twin", "unit.json", "--output", "OUT.json"},
       {"plain.json", "a.png", "unit.json"}},
      {"generate",
       "generate",
       {"--generate", "scene", "--session", "plain.json", "--output", "OUT.png"},
       {"plain.json"}},
      {"generate for views",
       "generate",
       {"--generate", "scene", "--session", "v", "--output", "OUT.png"},
       ofViews.mid(1)},
      {"pack",
       "pack",
       {"--pack", "b.png", "--session", "s.json", "--output", "OUT.tif"},
       ofSession.mid(2) + QStringList{"s.json", "b.png"}},
      {"export views", "export",
       QStringList{"--export", "views", "--session", "mesh.json", "--output", "out"} + kept,
       ofMesh},
      {"export its own views",
       "export",
       {"--export", "views", "--session", "views.json", "--output", "w", "--for-twin", "--twin",
        "unit.json"},
       ofViews + QStringList{"unit.json"}},
      {"export hogels",
       "export",
       {"--export", "hogels", "--session", "s.json", "--output", "OUT.png"},
       ofSession},
      {"export pack", "export",
       QStringList{"--export", "pack", "--session", "s.json", "--output", "OUT.tif"} + kept,
       ofSession},
      {"export woven",
       "export",
       {"--export", "woven", "--session", "sheet.json", "--output", "OUT.png"},
       ofSheet},
      {"export rig", "export",
       QStringList{"--export", "rig", "--session", "mesh.json", "--output", "OUT.json"} + kept,
       ofMesh},
      {"optimise", "optimise",
       QStringList{"--optimise", "hogels", "--session", "s.json", "--output", "OUT.png"} + kept,
       ofSession},
      {"optimise for pictures",
       "optimise",
       {"--optimise", "views", "--session", "plain.json", "--output", "out", "--twin", "unit.json",
        "--set", "optimise.target=views", "--set", "optimise.views=wanted"},
       {"plain.json", "a.png", "unit.json", "wanted/s0.png", "wanted/s1.png"}},
      {"optimise a store",
       "optimise",
       {"--optimise", "pack", "--session", "plain.json", "--output", "OUT.tif"},
       {"plain.json", "a.png"}},
      {"trade-off",
       "tradeoff",
       QStringList{"--tradeoff", "--session", "plain.json", "--output", "out", "--budget", "0.01",
                   "--calibration", "camera.json"} +
           kept,
       {"plain.json", "a.png", "camera.json"}},
      {"stability",
       "stability",
       {"--stability", "--output", "out", "--calibrations", "camera.json"},
       {"camera.json"}},
      {"measure", "measure",
       QStringList{"--measure", "--session", "s.json", "--output", "out", "--calibration",
                   "camera.json"} +
           kept,
       ofSession + QStringList{"camera.json"}},
      {"measure of a unit",
       "measure",
       {"--measure", "--session", "plain.json", "--output", "out", "--twin", "unit.json"},
       {"plain.json", "a.png", "unit.json"}},
      {"measure of a sheet",
       "measure",
       {"--measure", "--session", "sheet.json", "--output", "out"},
       ofSheet,
       true},
      {"sweep", "sweep",
       QStringList{"--sweep", "table.json", "--session", "s.json", "--output", "out",
                   "--calibration", "camera.json"} +
           kept,
       ofSession + QStringList{"camera.json", "table.json", "b.png"}},
      {"depth", "depth",
       QStringList{"--depth", "--session", "mesh.json", "--output", "out", "--calibration",
                   "camera.json", "--fit", "fitted.json"} +
           kept,
       ofMesh + QStringList{"camera.json"}},
      {"votes",
       "votes",
       {"--votes", "first.json", "--votes", "second.json", "--output", "out"},
       {"first.json", "second.json"}},
      {"info", "info", {"--info", "v", "--output", "out"}, ofViews.mid(1)}};
}

/// Returns the files below the current folder.
std::set<QString> filesHere() {
  std::set<QString> files;
  QDirIterator all(".", QDir::Files | QDir::Hidden | QDir::System, QDirIterator::Subdirectories);
  while (all.hasNext()) files.insert(QDir().relativeFilePath(all.next()));
  return files;
}

/// Makes `output` a link to `input`; both are in the current folder.
void link(const QString& output, const QString& input) {
  QDir().mkpath(QFileInfo(output).path());
  QFile::remove(output);
  QVERIFY(QFile::link(QFileInfo(input).absoluteFilePath(), output));
  QVERIFY(QFileInfo(output).exists());
}

}  // namespace

class TestInputsKept : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyInputOptionIsTried();
  void inputsAreKept_data();
  void inputsAreKept();
  void inputsAreInTheKey_data();
  void inputsAreInTheKey();
};

void TestInputsKept::everyInputOptionIsTried() {
  std::set<std::pair<QString, QString>> tried;
  for (const Case& one : cases())
    for (const QString& word : one.arguments)
      if (word.startsWith("--")) tried.emplace(word.mid(2), one.job);
  const auto textOf = [](std::string_view text) {
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
  };
  for (const Flag& flag : allFlags())
    for (const Job* const job : jobsOf(flag))
      if ((flag.isInput && job->name != "export" && job->name != "make-twin") ||
          flag.name == "output" || flag.name == "save-session") {
        const QString name = textOf(flag.name);
        QVERIFY2(tried.contains({name, textOf(job->name)}),
                 qPrintable(name + " of --" + textOf(job->name)));
      }
}

void TestInputsKept::inputsAreKept_data() {
  QTest::addColumn<int>("index");
  const auto all = cases();
  for (int k = 0; k < int(all.size()); ++k)
    if (!all[std::size_t(k)].isSlow) QTest::newRow(qPrintable(all[std::size_t(k)].name)) << k;
}

void TestInputsKept::inputsAreKept() {
  QFETCH(int, index);
  const Case one = cases()[std::size_t(index)];
  const QTemporaryDir pristine;
  QVERIFY(QDir::setCurrent(pristine.path()));
  writeInputs();
  const std::set<QString> before = filesHere();
  QStringList arguments = one.arguments;
  if (one.job != "info") arguments << "--quiet";
  const Outcome plain = run(arguments, pristine.path());
  QVERIFY2(plain.status == 0, plain.err);
  std::vector<QString> outputs;
  const bool all = qEnvironmentVariableIsSet("HOGELSCOPE_ALL_PAIRS");
  std::set<QString> kinds;  // of plots, of which one is enough
  for (const QString& file : filesHere()) {
    if (before.contains(file)) continue;
    const QFileInfo info(file);
    const bool isPlot = info.path().endsWith("plots");
    if (all || !isPlot || kinds.insert(info.path() + "." + info.suffix()).second)
      outputs.push_back(file);
  }
  QVERIFY(!outputs.empty());
  for (const QString& input : one.inputs) QVERIFY2(before.contains(input), qPrintable(input));

  const auto inputs = std::size_t(one.inputs.size());
  const std::size_t pairs = all ? outputs.size() * inputs : std::max(outputs.size(), inputs);
  for (std::size_t k = 0; k < pairs; ++k) {
    const QString& output = outputs[all ? k / inputs : k % outputs.size()];
    const QString& input = one.inputs[qsizetype(k % inputs)];
    const QTemporaryDir folder;
    QVERIFY(QDir::setCurrent(folder.path()));
    writeInputs();
    const QByteArray content = contentOf(input);
    link(output, input);
    const Outcome outcome = run(arguments, folder.path());
    const QString pair = one.name + ": " + output + " over " + input + ": ";
    QVERIFY2(contentOf(input) == content, qPrintable(pair + "replaced"));
    QVERIFY2(outcome.status == 2 && outcome.err.count('\n') == 1,
             qPrintable(pair + QString::number(outcome.status) + " " + outcome.err));
  }
}

void TestInputsKept::inputsAreInTheKey_data() {
  QTest::addColumn<int>("index");
  const auto all = cases();
  for (int k = 0; k < int(all.size()); ++k) {
    const Case& one = all[std::size_t(k)];
    if (one.job == "report" || one.job == "measure" || one.job == "sweep")
      QTest::newRow(qPrintable(one.name)) << k;
  }
}

void TestInputsKept::inputsAreInTheKey() {
  QFETCH(int, index);
  const Case one = cases()[std::size_t(index)];
  // A line's end more does not change what these say, and what they say is in the key.
  QStringList documents{"s.json",      "plain.json", "test.json",     "sheet.json",
                        "camera.json", "table.json", "campaign.json", "rates.csv"};
  if (one.job == "measure")
    documents << "a.png"
              << "quilt_qs2x1a1.png";
  for (const QString& input : QStringList{""} + one.inputs) {  // "": nothing is changed
    if (documents.contains(input)) continue;
    const QTemporaryDir folder;
    QVERIFY(QDir::setCurrent(folder.path()));
    writeInputs();
    const QStringList shard{"--shard", "1/9"};
    const Outcome begun = run(one.arguments + shard, folder.path());
    QVERIFY2(begun.status == 0, begun.err);
    if (!input.isEmpty()) writeFile(input, contentOf(input) + "\n");
    const bool isReport = one.job == "report";  // of which only the whole says it
    const Outcome outcome = run(one.arguments + (isReport ? QStringList() : shard), folder.path());
    QVERIFY2(outcome.status == 0, outcome.err);
    QVERIFY2(outcome.err.contains("went on after") == input.isEmpty(),
             qPrintable(input + ": " + outcome.err));
  }
}

QTEST_GUILESS_MAIN(TestInputsKept)
#include "test_inputs_kept.moc"
