// SPDX-License-Identifier: BSD-3-Clause
// Twins in documents: what is read is written, a session names its twin's document or holds it, and
// every mistake is told with its place.
#include "io/documents/twin_file.h"

#include <QTemporaryDir>
#include <QTest>

#include "io/documents/session_file.h"
#include "io/documents/session_parts.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

const QByteArray whole = R"({
  "lensArray": {"offset": [2e-5, -1e-5], "rotation": 0.02, "pitchError": [3e-4, 2e-4],
                "gapError": 0.02, "wedge": [0.01, 0], "focalError": -0.01, "outside": "neighbour"},
  "colour": {"scale": [-0.004, 0, 0.006], "wavelengths": [6e-7, 5e-7, 4e-7]},
  "leakage": {"sigmaGrowth": 1.5},
  "light": {"black": 0.001, "ambient": [0.01, 0.02, 0.03], "falloff": 2, "bits": 6,
            "eotf": "gamma22", "fill": [0.9, 0.8]},
  "dead": {"rows": [3], "columns": [1, 2], "hogels": [[0, 1]]},
  "random": {"seed": 7, "shift": {"sigma": 3e-6, "length": 2}, "gain": {"sigma": 0.03}},
  "maps": {"hogels": "unit7.exr", "directions": "gonio.csv", "kernels": "", "height": "h.exr"}})";

QByteArray linear(const QByteArray& twin) {
  return R"({"hogelscope": 1, "display": {"hogels": [4, 3], "directions": [5, 6]}, "twin": )" +
         twin + R"(, "lightField": {"file": "scene.png"},
         "cameras": [{"name": "a", "psf": {"light": "linear"}}]})";
}

Session parsed(const QByteArray& text, const char* folder = "") {
  return parseSession(text.toStdString(), folder, {}, {});
}

}  // namespace

class TestTwinFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void readsAndWritesAll();
  void leavesOutWhatIsAsDesigned();
  void aSessionNamesItsTwin();
  void overridesMakeAnotherTwin();
  void mistakes_data();
  void mistakes();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestTwinFile::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestTwinFile::readsAndWritesAll() {
  TwinParams twin;
  readParts(parseJson(whole.toStdString()), "twin", twin);
  QCOMPARE(twin.lensArray.pitchError, (std::array{3e-4, 2e-4}));
  QCOMPARE(twin.lensArray.outside, OutsideField::neighbour);
  QCOMPARE(twin.light.eotf, Eotf::gamma22);
  QCOMPARE(twin.dead.columns, (std::vector{1, 2}));
  QCOMPARE(twin.dead.hogels, (std::vector{std::array{0, 1}}));
  QCOMPARE(twin.random.shift.length, 2.0);
  TwinParams reread;
  readParts(writtenParts(twin), "twin", reread);
  QVERIFY(reread == twin);
  writeFile("far/bare.json", whole);
  saveTwin("far/unit.json", twin);
  TwinParams again = loadTwin("far/unit.json");
  QVERIFY(again == twin);
  QVERIFY(contentOf("far/unit.json").contains("\"../unit7.exr\""));
  // The twin alone is a document too, and its files lie beside it.
  again = loadTwin("far/bare.json");
  QCOMPARE(again.maps.hogels, std::string("far/unit7.exr"));
}

void TestTwinFile::leavesOutWhatIsAsDesigned() {
  QVERIFY(writtenParts(TwinParams{}).empty());
  const QByteArray text = QByteArray::fromStdString(textOf(parsed(linear("{}"))));
  QVERIFY2(!text.contains("twin"), text);
  QVERIFY(!QByteArray::fromStdString(textOf(parsed(linear(R"({"light": {"black": 0.01}})"))))
               .contains("lensArray"));
}

void TestTwinFile::aSessionNamesItsTwin() {
  writeFile("units/seven.json", R"({"hogelscope": 1, "twin": )" + whole + "}");
  writeFile("s.json", linear("\"units/seven.json\""));
  const Session session = loadSession("s.json");
  QCOMPARE(session.twinFile, std::string("units/seven.json"));
  QCOMPARE(session.twin.maps.hogels, std::string("units/unit7.exr"));
  QCOMPARE(sessionFiles(session).size(), std::size_t{4});
  QVERIFY(QDir().mkpath("other"));
  saveSession("other/s.json", session);
  QVERIFY(contentOf("other/s.json").contains("\"twin\": \"../units/seven.json\""));
  QVERIFY(loadSession("other/s.json").twin.lensArray == session.twin.lensArray);
  // A state may be added to a session that names its twin.
  CameraState state;
  state.camera.name = "b";
  state.psf.light = LightModel::linear;
  appendStates("s.json", {state});
  QVERIFY(contentOf("s.json").contains("\"twin\": \"units/seven.json\""));
}

void TestTwinFile::overridesMakeAnotherTwin() {
  writeFile("seven.json", whole);
  writeFile("s.json", linear("\"seven.json\""));
  const Session changed = loadSession("s.json", {"twin.lensArray.rotation=1"});
  QCOMPARE(changed.twin.lensArray.rotation, 1.0);
  QCOMPARE(changed.twin.lensArray.gapError, 0.02);
  QVERIFY(changed.twinFile.empty());
  QCOMPARE(overridden(loadSession("s.json"), {"twin.random.seed=9"}).twin.random.seed, 9);
  QCOMPARE(overridden(loadSession("s.json"), {"psf.sigma=1"}).twinFile, std::string("seven.json"));
}

void TestTwinFile::mistakes_data() {
  QTest::addColumn<QByteArray>("twin");
  QTest::addColumn<QString>("line");
  const auto row = [](const QByteArray& twin, const char* line) {
    QTest::newRow(twin) << twin << QString("twin") + line;
  };
  row(R"({"lensArrey": {}})", ".lensArrey: is not known here; did you mean \"lensArray\"?");
  row(R"({"lensArray": {"offset": [1]}})", ".lensArray.offset: …");
  row(R"({"lensArray": {"outside": "bright"}})", ".lensArray.outside: …");
  row(R"({"light": {"black": 2}})", ".light.black: …");
  row(R"({"light": {"eotf": "pq"}})", ".light.eotf: …");
  row(R"({"dead": {"rows": [-1]}})", ".dead.rows: -1 is not a number from 0 on");
  row(R"({"dead": {"rows": 3}})", ".dead.rows: is not a list of numbers: [3, 17]");
  row(R"({"dead": {"hogels": [[1, 2, 3]]}})",
      ".dead.hogels: [1,2,3] is not a hogel: [column, row]");
  row(R"({"random": {"shift": {"sigma": -1}}})", ".random.shift.sigma: …");
  row(R"({"random": {"tilt": {}}})", ".random.tilt: is not known here; …");
  row("3", ": …");
}

void TestTwinFile::mistakes() {
  QFETCH(const QByteArray, twin);
  QFETCH(const QString, line);
  const QString error = errorOf([&] { (void)parsed(linear(twin)); });
  compareLine(error.toUtf8(), line.toUtf8());
  if (twin == "3") return;
  writeFile("bad.json", twin);
  compareLine(errorOf([&] { (void)parsed(linear("\"bad.json\"")); }).toUtf8(), line.toUtf8());
  compareLine(errorOf([&] { (void)loadTwin("bad.json"); }).toUtf8(), "bad.json: " + line.toUtf8());
}

QTEST_GUILESS_MAIN(TestTwinFile)
#include "test_twin_file.moc"
