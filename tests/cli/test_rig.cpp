// SPDX-License-Identifier: BSD-3-Clause
// Tests --export rig: what its cameras see of a live scene is what --export views writes, and what
// it refuses.
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

namespace {

QJsonObject jsonOf(const QString& file) {
  return QJsonDocument::fromJson(contentOf(file)).object();
}

/// A session of the live scene. `display` and `states` are JSON.
QByteArray liveSession(const QByteArray& display, const QByteArray& states) {
  return R"({"hogelscope": 1, "display": {"size": [0.5, 0.3], "hogels": [40, 24],
             "directions": [4, 3], "fov": [40, 30])" +
         display + R"(}, "lightField": {"layout": "live", "source": "scene",
             "viewingDistance": 0.6, "scene": {"samples": 1}}, "cameras": )" +
         states + "}";
}

}  // namespace

class TestRig : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void camerasSeeTheViews_data();
  void camerasSeeTheViews();
  void gltf();
  void needsNoLightField();
  void mistakes_data();
  void mistakes();
  void tooManyViews();

 private:
  [[nodiscard]] Outcome program(const QStringList& arguments) const {
    return run(arguments, m_folder->path());
  }
  [[nodiscard]] Outcome rig(const QStringList& more = {}) const {
    return program(QStringList{"--export", "rig", "--session", "s.json"} + more);
  }
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestRig::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestRig::camerasSeeTheViews_data() {
  QTest::addColumn<QByteArray>("display");
  QTest::newRow("rectilinear") << QByteArray();
  QTest::newRow("equiangular") << QByteArray(R"(, "lens": "equiangular")");
  QTest::newRow("turned in the world")
      << QByteArray(R"(, "position": [1, 2, 3], "orientation": [10, 20, 30])");
}

/// The rig's cameras as states of a session, whose display stands in the world's origin, and their
/// ideal views. Views and rig must not differ but where a ray meets a colour's border.
void TestRig::camerasSeeTheViews() {
  QFETCH(QByteArray, display);
  writeFile("s.json", liveSession(display, R"([{"name": "a"}])"));
  QCOMPARE(program({"--export", "views", "--session", "s.json", "--output", "views"}).status, 0);
  const Outcome outcome = rig({"--output", "rig.json"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.out, QByteArray("rig.json, rig.gltf: 12 camera(s)\n"));

  const QJsonArray cameras = jsonOf("rig.json")["cameras"].toArray();
  QCOMPARE(cameras.size(), 12);
  QJsonArray states;
  for (const QJsonValue& camera : cameras) {
    const QJsonArray position = camera["position"].toArray();
    states << QJsonObject{{"name", camera["name"]},
                          {"eye", position},
                          {"lookat", QJsonArray{position[0], position[1], 0}},
                          {"res", camera["res"]},
                          {"intrinsics", QJsonObject{{"fx", camera["fx"]},
                                                     {"fy", camera["fy"]},
                                                     {"cx", camera["cx"]},
                                                     {"cy", camera["cy"]}}}};
  }
  QByteArray lens = display.contains("equiangular") ? display : QByteArray();
  writeFile("seen.json", liveSession(lens, QJsonDocument(states).toJson()));
  QCOMPARE(program({"--render", "--ideal", "--session", "seen.json", "--output", "seen"}).status,
           0);

  QCOMPARE(namesIn("seen"), namesIn("views"));
  int others = 0;
  for (const QJsonValue& camera : cameras) {
    const QString name = camera["name"].toString();
    QCOMPARE(name, QString("%1_%2")
                       .arg(camera["v"].toInt(), 3, 10, QChar('0'))
                       .arg(camera["u"].toInt(), 3, 10, QChar('0')));
    const QImage seen("seen/" + name + ".png");
    const QImage view("views/" + name + ".png");
    QCOMPARE(seen.size(), QSize(40, 24));
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 40; ++x) others += seen.pixel(x, y) != view.pixel(x, y);
  }
  QVERIFY2(others <= 12, qPrintable(QString("%1 of 11520").arg(others)));
  QVERIFY(QImage("views/000_000.png") != QImage("views/002_003.png"));
}

void TestRig::gltf() {
  writeFile("s.json", liveSession({}, R"([{"name": "a"}])"));
  QCOMPARE(rig({"--output", "rig.json", "--quiet"}).out, QByteArray());
  const QJsonArray cameras = jsonOf("rig.json")["cameras"].toArray();
  const QJsonObject gltf = jsonOf("rig.gltf");
  QCOMPARE(gltf["asset"]["version"].toString(), QString("2.0"));
  QCOMPARE(gltf["nodes"].toArray().size(), 12);
  for (int k = 0; k < 12; ++k) {
    const QJsonValue camera = cameras[k];
    const QJsonValue node = gltf["nodes"][k];
    const QJsonArray matrix = node["matrix"].toArray();
    for (int axis = 0; axis < 3; ++axis) {
      QCOMPARE(matrix[12 + axis], camera["position"][axis]);
      for (int other = 0; other < 3; ++other)  // glTF's cameras look along -z, as the rig's
        QCOMPARE(matrix[4 * axis + other].toDouble(), axis == other ? 1.0 : 0.0);
    }
    const QJsonValue lens = gltf["cameras"][node["camera"].toInt()];
    QCOMPARE(lens["name"], camera["name"]);
    for (const char* key : {"fx", "fy", "cx", "cy"})
      QCOMPARE(lens["extras"][key], camera[QLatin1String(key)]);
    // The panel of 0.3 m fills the image at 0.6 m.
    QVERIFY(std::abs(lens["perspective"]["yfov"].toDouble() - 2 * std::atan(0.25)) < 1e-12);
    QVERIFY(std::abs(lens["perspective"]["aspectRatio"].toDouble() - 0.5 / 0.3) < 1e-12);
  }
}

void TestRig::needsNoLightField() {
  Sections sections;
  sections.lightField = R"({"file": "not yet", "layout": "views", "viewingDistance": 1})";
  writeFile("s.json", text(sections));
  const Outcome outcome = rig({"--output", "new/rig.json"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(namesIn("new"), (QStringList{"rig.gltf", "rig.json"}));
}

void TestRig::mistakes_data() {
  QTest::addColumn<QByteArray>("lightField");
  QTest::addColumn<QString>("output");
  QTest::addColumn<QByteArray>("message");
  const QByteArray far = R"({"file": "f.png", "viewingDistance": 1})";
  QTest::newRow("parallel rays") << QByteArray(R"({"file": "f.png"})") << "rig.json"
                                 << QByteArray(
                                        "hogelscope: s.json: lightField.viewingDistance: is not "
                                        "given, so all rays of a view are parallel and no camera "
                                        "has them: --set lightField.viewingDistance=0.6 for "
                                        "cameras 0.6 m in front of the panel\n");
  QTest::newRow("the name of the other file") << far << "rig.gltf"
                                              << QByteArray(
                                                     "hogelscope: --output rig.gltf: is the name "
                                                     "of the glTF file beside the rig: end it in "
                                                     ".json\n");
  QTest::newRow("over the session") << far << "s.json" << QByteArray("hogelscope: s.json: …");
}

void TestRig::mistakes() {
  QFETCH(QByteArray, lightField);
  QFETCH(QString, output);
  QFETCH(QByteArray, message);
  Sections sections;
  sections.lightField = lightField;
  writeFile("s.json", text(sections));
  const Outcome outcome = rig({"--output", output});
  QCOMPARE(outcome.status, 2);
  compareLine(outcome.err.trimmed(), message.trimmed());
  QCOMPARE(namesIn("."), QStringList{"s.json"});
  QCOMPARE(contentOf("s.json"), text(sections));
}

void TestRig::tooManyViews() {
  writeFile("s.json", liveSession({}, R"([{"name": "a"}])"));
  const Outcome outcome = rig({"--output", "rig.json", "--set", "display.directions=[9000,9000]"});
  QCOMPARE(outcome.err,
           QByteArray("hogelscope: s.json: display.directions: 9000×9000 views are more than a "
                      "million cameras, the most that a rig has\n"));
  QCOMPARE(outcome.status, 2);
  QCOMPARE(namesIn("."), QStringList{"s.json"});
}

QTEST_GUILESS_MAIN(TestRig)
#include "test_rig.moc"
