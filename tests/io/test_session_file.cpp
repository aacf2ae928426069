// SPDX-License-Identifier: BSD-3-Clause
// Tests loading and saving session documents.
#include <QTemporaryDir>
#include <QTest>

#include "io/documents/session_file.h"
#include "tests/io/documents.h"

using namespace hogelscope;

class TestSessionFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void roundTrip_data();
  void roundTrip();
  void savedFileIsForReaders();
  void fileStaysRelative_data();
  void fileStaysRelative();
  void unknownKeys_data();
  void unknownKeys();
  void sessionsByName();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSessionFile::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestSessionFile::roundTrip_data() {
  QTest::addColumn<QByteArray>("document");
  QTest::newRow("little") << text();
  QTest::newRow("display") << text(
      {.display = R"({"position": [1, -2, 3.25], "orientation": [10, -20, 359.5], "fov": [30, 170],
                      "size": [1e-6, 1e6], "hogels": [65536, 1], "directions": [7, 65536],
                      "lens": "equiangular"})"});
  QTest::newRow("views") << text(
      {.display = "{}", .lightField = R"({"file": "a/b c", "layout": "views",
      "incoming": true, "rows": "bottom-up", "columns": "right-left", "pattern": "x_RR_CC_*",
      "shear": [5.6, -1e4]})"});
  QTest::newRow("quilt") << text(
      {.display = R"({"fov": [40, 40]})", .lightField = R"({"file": "q.png", "layout": "quilt",
                                                    "columns": 8, "rows": 4096})"});
  QTest::newRow("quilt, tiles from its name")
      << text({.display = "{}", .lightField = R"({"file": "q_qs8x6a1.png", "layout": "quilt"})"});
  QTest::newRow("sampling") << text(
      {.sampling = R"({"mapping": "direct", "samplesPerPixel": 64, "tolerance": 0.75,
                                                     "reconstruction": "quadrilinear"})"});
  QTest::newRow("states") << text({.cameras = R"([
      {"name": "é \"quoted\" 日本 😀", "eye": [0.1, 0.2, 0.30000000000000004], "lookat": [1, 2, -3],
       "up": [0, 0, 1e-6], "fov": 179.9, "res": [1, 16384], "weight": 0.25,
       "distortion": {"k1": -0.45, "k2": 0.25, "p1": 1e-17, "p2": -10, "k3": 3.3333333333333335},
       "psf": {"sigma": 20, "windowSize": 99, "border": "black", "light": "linear"}},
      {"name": "calibrated", "intrinsics": {"fx": 535.9, "fy": 534.25, "cx": -3.5, "cy": 1e6}},
      {"name": "square pixels", "intrinsics": {"fx": 0.001}},
      {"name": "plain"}])"});
  QFile sample(HOGELSCOPE_SOURCE_DIR "/data/table1.json");
  QVERIFY(sample.open(QIODevice::ReadOnly));
  QTest::newRow("the sample session") << sample.readAll();
}

void TestSessionFile::roundTrip() {
  QFETCH(QByteArray, document);
  writeFile("s.json", document);
  const Session first = loadSession("s.json");
  const char* second = "other/t.json";
  writeFile(second, "to be replaced");
  saveSession(second, first);
  QVERIFY(loadSession(second) == first);
  const QByteArray saved = contentOf(second);
  saveSession(second, loadSession(second));
  QCOMPARE(contentOf(second), saved);
  QCOMPARE(namesIn("other"), QStringList{"t.json"});
}

void TestSessionFile::savedFileIsForReaders() {
  const QByteArray cameras = R"([{"name": "a", "eye": [0, 0, 0.559], "res": [60, 40]}])";
  writeFile("s.json", text({.cameras = cameras}));
  saveSession("t.json", loadSession("s.json"));
  QCOMPARE(contentOf("t.json"), QByteArray(R"({
  "hogelscope": 1,
  "display": {
    "position": [0.0,0.0,0.0],
    "orientation": [0.0,0.0,0.0],
    "size": [0.5,0.5],
    "hogels": [4,3],
    "directions": [5,6],
    "fov": [60.0,60.0],
    "lens": "rectilinear"
  },
  "lightField": {
    "file": "scene.png",
    "layout": "hogels",
    "incoming": false
  },
  "sampling": {
    "mapping": "exact",
    "reconstruction": "nearest",
    "samplesPerPixel": 1,
    "tolerance": 0.0
  },
  "cameras": [
    {
      "name": "a",
      "eye": [0.0,0.0,0.559],
      "lookat": [0.0,0.0,0.0],
      "up": [0.0,1.0,0.0],
      "fov": 60.0,
      "res": [60,40],
      "weight": 1.0,
      "distortion": {
        "k1": 0.0,
        "k2": 0.0,
        "p1": 0.0,
        "p2": 0.0,
        "k3": 0.0
      },
      "psf": {
        "sigma": 0.67,
        "windowSize": 1,
        "border": "renormalise",
        "light": "encoded"
      }
    }
  ]
}
)"));
}

void TestSessionFile::fileStaysRelative_data() {
  QTest::addColumn<QString>("document");
  QTest::addColumn<QByteArray>("file");
  QTest::addColumn<QString>("loaded");
  QTest::addColumn<QString>("target");
  QTest::addColumn<QByteArray>("saved");
  QTest::newRow("same folder") << "s.json" << QByteArray("scene.png") << "scene.png"
                               << "t.json" << QByteArray("scene.png");
  QTest::newRow("deeper") << "s.json" << QByteArray("scene.png") << "scene.png"
                          << "a/b/t.json" << QByteArray("../../scene.png");
  QTest::newRow("higher") << "a/b/s.json" << QByteArray("scene.png") << "a/b/scene.png"
                          << "t.json" << QByteArray("a/b/scene.png");
  QTest::newRow("beside") << "a/s.json" << QByteArray("../c/./views") << "c/views"
                          << "b/t.json" << QByteArray("../c/views");
  QTest::newRow("%-pattern") << "a/s.json" << QByteArray("v/%02d_%02d.png") << "a/v/%02d_%02d.png"
                             << "t.json" << QByteArray("a/v/%02d_%02d.png");
  QTest::newRow("the folder itself") << "a/s.json" << QByteArray(".") << "a"
                                     << "b/t.json" << QByteArray("../a");
}

void TestSessionFile::fileStaysRelative() {
  QFETCH(QString, document);
  QFETCH(QByteArray, file);
  QFETCH(QString, loaded);
  QFETCH(QString, target);
  QFETCH(QByteArray, saved);
  writeFile(document, text({.lightField = R"({"file": ")" + file + R"("})"}));
  const Session session = loadSession(document.toStdString());
  QCOMPARE(QString::fromStdString(session.lightField.file), loaded);
  writeFile(target, "");
  saveSession(target.toStdString(), session);
  QVERIFY2(contentOf(target).contains(R"("file": ")" + saved + R"(")"), contentOf(target));
  QVERIFY(loadSession(target.toStdString()) == session);
}

void TestSessionFile::unknownKeys_data() {
  QTest::addColumn<QByteArray>("document");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* key, const char* nearest, const Sections& sections) {
    QTest::newRow(key)
        << text(sections)
        << QString("s.json: %1: is not known here; did you mean \"%2\"?").arg(key, nearest);
  };
  row("display.hogel", "hogels", {.display = R"({"hogel": [4, 3]})"});
  row("display.FOV", "fov", {.display = R"({"FOV": [4, 3]})"});
  row("lightField.flie", "file", {.lightField = R"({"flie": "x"})"});
  row("sampling.reconstuction", "reconstruction", {.sampling = R"({"reconstuction": "nearest"})"});
  row("cameras[1].lookAt", "lookat", {.cameras = R"([{"name": "a"}, {"name": "b", "lookAt": 1}])"});
  row("cameras[0].distortion.k7", "k1", {.cameras = R"([{"name": "a", "distortion": {"k7": 0}}])"});
  row("cameras[0].psf.windowsize", "windowSize",
      {.cameras = R"([{"name": "a", "psf": {"windowsize": 3}}])"});
}

void TestSessionFile::unknownKeys() {
  QFETCH(QByteArray, document);
  QFETCH(QString, line);
  writeFile("s.json", document);
  QCOMPARE(errorOf([] { (void)loadSession("s.json"); }), line);
}

void TestSessionFile::sessionsByName() {
  QVERIFY(isSessionFile("a/b.json"));
  QVERIFY(isSessionFile("B.JSON"));
  QVERIFY(!isSessionFile("json"));
  QVERIFY(!isSessionFile("a.json/b.png"));
}

QTEST_APPLESS_MAIN(TestSessionFile)
#include "test_session_file.moc"
