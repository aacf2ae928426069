// SPDX-License-Identifier: BSD-3-Clause
// Tests --depth as a user runs it: files and figures of a live scene and of views, the fitted
// session, what it refuses.
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <numbers>

#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

namespace {

const QString room = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/data/room.json");

QJsonObject jsonOf(const QString& file) {
  return QJsonDocument::fromJson(contentOf(file)).object();
}

bool isNear(double a, double b, double by = 1e-9) {
  return std::abs(a - b) <= by * std::max({1.0, std::abs(a), std::abs(b)});
}

}  // namespace

class TestDepthJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void ofALiveScene();
  void ofViews();
  void ofTwoPlanes();
  void ofTheEyes();
  void leavesNothingElsewhere();
  void mistakes_data();
  void mistakes();

 private:
  [[nodiscard]] Outcome depth(const QString& session, const QStringList& more) const {
    return run(QStringList{"--depth", "--session", session, "--set", "camera.res=[50,40]"} + more,
               m_folder->path());
  }
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestDepthJob::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestDepthJob::ofALiveScene() {
  const Outcome outcome = depth(room, {"--output", "out", "--fit", "fit.json"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
  QCOMPARE(namesIn("out"),
           (QStringList{"depth.csv", "depth.json", "depth.png", "depth.svg", "plots"}));
  QCOMPARE(namesIn("out/plots"),
           (QStringList{"depth_now.csv", "depth_now.svg", "depth_now_page.svg",
                        "depth_proposed.csv", "depth_proposed.svg", "depth_proposed_page.svg"}));
  QCOMPARE(tableOf("out/plots/depth_now.csv").size(), 161);
  QVERIFY(!QImage("out/depth.png").isNull());
  QVERIFY(contentOf("out/depth.svg").contains("<svg"));

  const QJsonObject json = jsonOf("out/depth.json");
  constexpr double distance = 0.56;
  const double pitch = 0.5 / 256;
  const double slope = 2 * std::tan(std::numbers::pi / 6) / 150;
  const auto pair = [&](const char* name) {
    const QJsonObject range = json[name].toObject();
    return std::pair(range["front"].toDouble(), range["behind"].toDouble());
  };
  const auto [front, behind] = pair("limits");
  QVERIFY(isNear(front, pitch * distance / (slope * distance + pitch)));
  QVERIFY(isNear(behind, pitch * distance / (slope * distance - pitch)));
  const auto [before, after] = pair("comfort");
  const double comfort = std::numbers::pi / 180 / 0.063;
  QVERIFY(isNear(1 / (distance - before) - 1 / distance, comfort));
  QVERIFY(isNear(1 / distance - 1 / (distance + after), comfort));

  // The proposal brings the interval to the comfortable depths, the lesser ones here.
  const double z1 = json["interval"].toArray()[0].toDouble();
  const double z2 = json["interval"].toArray()[1].toDouble();
  QVERIFY(z1 < -0.29 && z2 > 0.03);
  const double scale = (before + after) / (z2 - z1);
  const double zero = (after * z2 + before * z1) / (after + before);
  const QJsonObject proposal = json["proposal"].toObject();
  QVERIFY(isNear(proposal["scale"].toDouble(), scale));
  QVERIFY(isNear(proposal["position"].toArray()[2].toDouble(), -scale * zero));
  const double inside = json["inside"].toObject()["both"].toDouble();
  const double proposed = json["proposed"].toObject()["both"].toDouble();
  QVERIFY(inside < 0.3 && proposed > 0.9);

  QList<QStringList> rows = tableOf("out/depth.csv");
  QCOMPARE(rows.takeFirst().join(","),
           QString("state,z,dioptres,disparity,mismatch,share,proposed"));
  QMap<QString, double> shares;
  for (const QStringList& row : rows) {
    const double z = row[1].toDouble();
    const double dioptres = row[2].toDouble();
    shares[row[0]] += row[5].toDouble();
    if (row[0] != "front") continue;
    QVERIFY(isNear(dioptres, 1 / (distance - z) - 1 / distance));
    QVERIFY(isNear(row[3].toDouble(), -slope * distance * distance * dioptres / pitch));
    QVERIFY(isNear(row[4].toDouble(), std::abs(dioptres)));  // 0.93 directions a pupil
  }
  QCOMPARE(shares.keys(), (QStringList{"above", "front", "left", "lens"}));
  for (const double share : shares) QVERIFY(isNear(share, 1));
  QCOMPARE(json["states"].toArray().size(), 4);

  // The written session is what was proposed, and nothing is left to do for it.
  QCOMPARE(depth("fit.json", {"--output", "again"}).status, 0);
  const QJsonObject again = jsonOf("again/depth.json");
  QVERIFY(isNear(again["inside"].toObject()["both"].toDouble(), proposed));
}

void TestDepthJob::ofViews() {
  QCOMPARE(run({"--export", "views", "--session", room, "--output", "views", "--set",
                "display.hogels=[96,96]", "--set", "display.directions=[9,9]", "--set",
                "display.fov=[12,12]"},
               m_folder->path())
               .status,
           0);
  writeFile("v.json", text({.display = R"({"hogels": [96, 96], "directions": [9, 9],
                                          "fov": [12, 12]})",
                            .lightField = R"({"file": "views", "layout": "views",
                                             "shear": [3, 3]})",
                            .cameras = R"([{"name": "a", "eye": [0, 0, 2], "fov": 15}])"}));
  const Outcome outcome = depth("v.json", {"--output", "out", "--fit", "fit.json"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
  const QJsonObject json = jsonOf("out/depth.json");
  QVERIFY(json["known"].toDouble() > 0.5);
  // The shear has put all of the room in front of the panel; without one it is where it was.
  const QJsonArray shear = json["proposal"].toObject()["shear"].toArray();
  QVERIFY2(std::abs(shear[0].toDouble()) < 1, qPrintable(QString::number(shear[0].toDouble())));
  QVERIFY(isNear(shear[0].toDouble(), shear[1].toDouble()));
  QVERIFY(json["inside"].toObject()["both"].toDouble() <
          json["proposed"].toObject()["both"].toDouble());
  QCOMPARE(jsonOf("fit.json")["lightField"].toObject()["shear"].toArray(), shear);
}

/// Two thirds of what views show shift by 0 hogels from one to the next, a third by 3, so that the
/// middle of both has nothing.
void TestDepthJob::ofTwoPlanes() {
  const auto noise = [](int x, int y) {
    const double value = 43758.5453 * std::sin(12.9898 * x + 78.233 * y);
    return float(value - std::floor(value));
  };
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      writeImageFile(QString("views/%1_%2.png").arg(row).arg(column), 72, 72,
                     [&](int x, int y, int) {
                       const int shift = x < 48 ? 0 : 3;
                       return noise(x - shift * column + 100, y - shift * row + 100);
                     });
  writeFile("v.json", text({.display = R"({"hogels": [72, 72], "directions": [3, 3],
                                          "fov": [20, 20], "size": [0.2, 0.2]})",
                            .lightField = R"({"file": "views", "layout": "views"})",
                            .cameras = R"([{"name": "a", "eye": [0, 0, 2], "fov": 6}])"}));
  const Outcome now = depth("v.json", {"--output", "now"});
  QCOMPARE(now.err, QByteArray());
  QCOMPARE(now.status, 0);
  QJsonObject json = jsonOf("now/depth.json");
  const double inside = json["inside"].toObject()["both"].toDouble();
  QVERIFY2(inside > 0.55 && inside < 0.9, now.out);
  QVERIFY2(now.out.contains("nothing is proposed: no other place has more"), now.out);
  QVERIFY(json["proposal"].isNull() && json["proposed"].isNull());
  QVERIFY(!QFile::exists("now/plots/depth_proposed.svg"));
  const Outcome fit = depth("v.json", {"--output", "now", "--fit", "fit.json"});
  QCOMPARE(fit.status, 2);
  QVERIFY2(fit.err.contains("--fit fit.json: there is nothing to write: no other place"), fit.err);
  QVERIFY(!QFile::exists("fit.json"));
  // Sheared away, most of it comes back to the panel.
  for (const double shear : {3.0, -3.0}) {
    const QString given = QString("lightField.shear=[%1,%1]").arg(shear);
    QCOMPARE(depth("v.json", {"--output", "away", "--set", given}).status, 0);
    json = jsonOf("away/depth.json");
    const double proposed = json["proposed"].toObject()["both"].toDouble();
    const double away = json["inside"].toObject()["both"].toDouble();
    QVERIFY2(away < 0.5 && proposed > 0.55, qPrintable(QString("%1 %2").arg(away).arg(proposed)));
    const double back = json["proposal"].toObject()["shear"].toArray()[0].toDouble();
    QVERIFY2(std::abs(back) < 1, qPrintable(QString::number(back)));
  }
}

void TestDepthJob::ofTheEyes() {
  const auto limitsOf = [&](const QStringList& more) {
    const Outcome outcome = depth(room, QStringList{"--output", "o", "--states", "front"} + more);
    return outcome.status == 0 ? jsonOf("o/depth.json") : QJsonObject();
  };
  const auto front = [](const QJsonObject& json) {
    return json["comfort"].toObject()["front"].toDouble();
  };
  const double comfort = std::numbers::pi / 180 / 0.032;
  QVERIFY(isNear(front(limitsOf({"--set", "stereo.ipd=0.032"})), 0.56 - 1 / (1 / 0.56 + comfort)));
  QVERIFY(isNear(front(limitsOf({"--set", "depth.ipd=0.064", "--set", "depth.comfort=2"})),
                 0.56 - 1 / (1 / 0.56 + comfort)));
  const QJsonObject wide = limitsOf({"--set", "pupil.diameter=0.008"});
  QVERIFY(isNear(wide["directionsPerPupil"].toDouble(), 2 * 0.9278843611976126, 1e-6));
  QCOMPARE(wide["mismatch"].toDouble(), 0.0);
}

/// Qt would make a folder in the place of temporary files where there is no XDG_RUNTIME_DIR.
void TestDepthJob::leavesNothingElsewhere() {
  QVERIFY(QDir().mkdir("tmp"));
  QProcessEnvironment environment = withoutDisplay();
  environment.remove("XDG_RUNTIME_DIR");
  environment.insert("TMPDIR", m_folder->filePath("tmp"));
  QProcess process;
  process.setProcessEnvironment(environment);
  process.setWorkingDirectory(m_folder->path());
  process.start(HOGELSCOPE_PROGRAM,
                {"--depth", "--session", room, "--states", "front", "--quiet", "--output", "out"});
  const Outcome outcome = ended(process);
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
  QCOMPARE(namesIn("tmp"), QStringList());
}

void TestDepthJob::mistakes_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("line");
  const auto scene = QStringList{"--session", "scene.json", "--output", "o"};
  QTest::newRow("content without a place")
      << scene + QStringList{"--fit", "f.json"}
      << QByteArray(
             "--fit f.json: there is nothing to write: lightField.source \"scene\" has no "
             "position and scale");
  QTest::newRow("not a session") << scene + QStringList{"--fit", "f.png"}
                                 << QByteArray("--fit f.png: cannot be written");
  QTest::newRow("over an input") << QStringList{"--session", "scene.json", "--output",
                                                "o",         "--fit",      "scene.json"}
                                 << QByteArray("scene.json");
  QTest::newRow("behind the panel") << scene + QStringList{"--set", "camera.eye=[0,0,-1]"}
                                    << QByteArray("a: its eye is not in front of the panel");
  QTest::newRow("looks away") << scene + QStringList{"--set", "camera.lookat=[0,0,5]"}
                              << QByteArray("a: sees no content whose depth is known");
  QTest::newRow("share") << scene + QStringList{"--set", "depth.share=2"}
                         << QByteArray("depth.share");
  QTest::newRow("unknown") << scene + QStringList{"--set", "depth.sahre=0.5"}
                           << QByteArray("did you mean \"share\"?");
  QTest::newRow("one direction") << QStringList{"--session", "one.json", "--output", "o"}
                                 << QByteArray("has one direction: its depths cannot be seen");
}

void TestDepthJob::mistakes() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, line);
  const QByteArray camera = R"([{"name": "a", "eye": [0, 0, 0.6], "res": [20, 20]}])";
  writeFile("scene.json", text({.display = R"({"hogels": [32, 32], "directions": [8, 8]})",
                                .lightField = R"({"layout": "live", "source": "scene"})",
                                .cameras = camera}));
  writeImageFile("a.png", 16, 16, [](int, int, int) { return 0.5F; });
  writeFile("one.json", text({.display = R"({"hogels": [16, 16], "directions": [1, 1]})",
                              .lightField = R"({"file": "a.png"})",
                              .cameras = camera}));
  const Outcome outcome = run(QStringList{"--depth"} + arguments, m_folder->path());
  QCOMPARE(outcome.status, 2);
  QVERIFY2(outcome.err.contains(line), outcome.err);
  QCOMPARE(outcome.err.count('\n'), 1);
  QVERIFY(!QFile::exists("o/depth.csv"));
}

QTEST_GUILESS_MAIN(TestDepthJob)
#include "test_depth_job.moc"
