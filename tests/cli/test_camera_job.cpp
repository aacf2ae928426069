// SPDX-License-Identifier: BSD-3-Clause
// Tests --make-cameras as a user runs it: the session that it writes, and that it renders.
#include <QTemporaryDir>
#include <QTest>

#include "io/documents/session_file.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

class TestCameraJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void setRendersAndSeesTheDisplay();
  void sameSeedSameBytes();
  void intoTheSessionItself();
  void onlySomeStatesAreKept();
  void templateIsLeftOut();
  void sessionSettingsAreTheSessions();
  void userDefined();
  void viewersTrace();
  void camerasOfAFile();
  void calibrationOfSeveral();
  void aHundredThousand();
  void mistakes_data();
  void mistakes();

 private:
  Outcome job(const QStringList& more) {
    return run(QStringList{"--session", "s.json", "--make-cameras"} + more, m_folder->path());
  }

  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCameraJob::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeImageFile("a.png", 128, 128, [](int, int, int) { return 1.0F; });
  writeFile("s.json", text({.display = R"({"hogels": [16, 16], "directions": [8, 8]})",
                            .lightField = R"({"file": "a.png"})",
                            .cameras = R"([{"name": "a", "res": [40, 30],
                              "distortion": {"k1": 0.1}, "psf": {"windowSize": 5}},
                              {"name": "b", "fov": 40}])"}));
}

/// The panel is white, so its middle is where it is seen.
void TestCameraJob::setRendersAndSeesTheDisplay() {
  const Outcome made =
      job({"uniform", "--region", "arc", "--count", "9", "--output", "new/s2.json"});
  QCOMPARE(made.err, QByteArray());
  QCOMPARE(made.out,
           QByteArray("9 camera state(s) added: uniform-0001 … uniform-0009; 11 in "
                      "new/s2.json\n"
                      "their lens, PSF, resolution and field of view are those of \"a\", "
                      "which stays (--set cameraSet.keepTemplate=false leaves it out)\n"));
  QCOMPARE(made.status, 0);
  const Session before = loadSession("s.json");
  Session after = loadSession("new/s2.json");
  QCOMPARE(QDir::cleanPath(QString::fromStdString(after.lightField.file)), QString("a.png"));
  QCOMPARE(after.cameras[2].distortion.k1, 0.1);
  after.lightField.file = before.lightField.file;
  after.cameras.resize(2);
  QVERIFY(after == before);
  const Outcome drawn =
      run({"--render", "--session", "new/s2.json", "--states", "uniform-*", "--output", "out"},
          m_folder->path());
  QCOMPARE(drawn.err, QByteArray());
  QCOMPARE(namesIn("out").size(), 9);
  for (const QString& name : namesIn("out")) {
    const auto values = bytesOf("out/" + name);
    QCOMPARE(values.size(), std::size_t(3 * 40 * 30));
    QVERIFY2(values[3 * (15 * 40 + 20)] == 255, qPrintable(name));
  }
}

void TestCameraJob::sameSeedSameBytes() {
  const auto madeBy = [this](const char* seed) {
    (void)job({"normal", "--count", "5", "--seed", seed, "--output", "s2.json", "--quiet"});
    return contentOf("s2.json");
  };
  const QByteArray first = madeBy("3");
  QCOMPARE(madeBy("3"), first);
  QVERIFY(madeBy("4") != first);
}

void TestCameraJob::intoTheSessionItself() {
  for (const int states : {5, 8}) {
    QCOMPARE(job({"random", "--count", "3", "--output", "s.json"}).status, 0);
    QCOMPARE(loadSession("s.json").cameras.size(), std::size_t(states));
  }
  QCOMPARE(loadSession("s.json").cameras.back().camera.name, std::string("random-0006"));
}

void TestCameraJob::onlySomeStatesAreKept() {
  QCOMPARE(job({"random", "--count", "1", "--states", "b", "--output", "s2.json"}).status, 0);
  const Session made = loadSession("s2.json");
  QCOMPARE(made.cameras.size(), std::size_t(2));
  QCOMPARE(made.cameras[1].camera.fov, 40.0);
}

void TestCameraJob::templateIsLeftOut() {
  const Outcome outcome = job({"random", "--count", "2", "--set", "cameraSet.template=b", "--set",
                               "cameraSet.keepTemplate=false", "--output", "s2.json"});
  QCOMPARE(outcome.out, QByteArray("2 camera state(s) added: random-0001 … random-0002; 3 in "
                                   "s2.json\ntheir lens, PSF, resolution and field of view are "
                                   "those of \"b\", which is left out\n"));
  const Session made = loadSession("s2.json");
  QCOMPARE(made.cameras.size(), std::size_t(3));
  QCOMPARE(made.cameras[0], loadSession("s.json").cameras[0]);
  QCOMPARE(made.cameras[1].camera.fov, 40.0);
  const Outcome alone = job({"random", "--count", "1", "--states", "b", "--set",
                             "cameraSet.keepTemplate=false", "--output", "s2.json"});
  QCOMPARE(alone.err, QByteArray());
  QCOMPARE(loadSession("s2.json").cameras.size(), std::size_t(1));
}

void TestCameraJob::sessionSettingsAreTheSessions() {
  const Outcome outcome =
      job({"random", "--count", "1", "--set", "psf.sigma=0.6", "--set", "cameraSet.template=b",
           "--set", "cameraSet.name=new one", "--output", "s2.json"});
  QCOMPARE(outcome.err, QByteArray());
  const CameraState state = loadSession("s2.json").cameras.back();
  QCOMPARE(state.camera.name, std::string("new one-0001"));
  QCOMPARE(state.camera.fov, 40.0);
  QCOMPARE(state.psf.sigma, 0.6);
}

void TestCameraJob::userDefined() {
  writeFile("where/c.json", R"({"hogelscopeCameras": 1, "poses": [{"eye": [0, 0, 1]},
                                {"eye": [0.1, 0, 1], "weight": 3}]})");
  QCOMPARE(job({"where/c.json", "--output", "s2.json"}).err, QByteArray());
  const Session made = loadSession("s2.json");
  QCOMPARE(made.cameras.size(), std::size_t(4));
  QCOMPARE(made.cameras[3].camera.name, std::string("pose-0002"));
  QCOMPARE(made.cameras[3].camera.weight, 3.0);
}

void TestCameraJob::viewersTrace() {
  writeFile("t.csv", "time,x,y\n0,0.1,0.01\n3,0.1,0.01\n3.001,-0.1,0.01\n4,-0.1,0.01\n");
  QCOMPARE(job({"t.csv", "--count", "4", "--output", "s2.json"}).err, QByteArray());
  const Session made = loadSession("s2.json");
  QCOMPARE(made.cameras.size(), std::size_t(4));
  QCOMPARE(made.cameras[2].camera.weight, 3.0);
  QCOMPARE(made.cameras[2].camera.eye, (Vec3{0.1, 0.01, 0.6}));
  QCOMPARE(made.cameras[3].camera.weight, 1.0);
}

/// States of all cameras, or of one; what is assumed is told, and --info says what the file has.
void TestCameraJob::camerasOfAFile() {
  const QByteArray frame = R"({"file_path": "images/%.png", "transform_matrix":
      [[1,0,0,0.1],[0,1,0,0.2],[0,0,1,6],[0,0,0,1]]})";
  const auto named = [&](const char* name) { return QByteArray(frame).replace("%", name); };
  writeFile("capture", R"({"fl_x": 500, "w": 640, "h": 480, "k1": 0.1, "frames": [)" + named("a1") +
                           "," + named("a2") + "]}");
  Outcome outcome = job({"capture", "--set", "cameraSet.scale=0.1", "--output", "s2.json"});
  QCOMPARE(outcome.err, QByteArray());
  QVERIFY2(outcome.out.startsWith("2 camera state(s) added: a1 … a2; "), outcome.out);
  const CameraState made = loadSession("s2.json").cameras.back();
  QCOMPARE(made.camera.name, std::string("a2"));
  QCOMPARE(made.camera.eye, (Vec3{0.01, 0.02, 0.6}));
  QCOMPARE(made.intrinsics.fx, 500.0);
  QCOMPARE(made.distortion.k1, 0.1);
  QCOMPARE(made.camera.res, (std::array{640, 480}));
  outcome = job({"capture", "--camera", "a1", "--output", "s3.json"});
  QCOMPARE(outcome.err,
           QByteArray("hogelscope: capture: says no unit of its places: one is taken for a metre; "
                      "cameraSet.scale says another\n"));
  QVERIFY2(outcome.out.startsWith("1 camera state(s) added: a1"), outcome.out);
  QCOMPARE(job({"uniform", "--camera", "a1", "--output", "s4.json"}).err,
           QByteArray("hogelscope: --camera a1: uniform is no file of cameras\n"));
  writeFile("k.json", R"({"K": [50, 0, 32, 0, 50, 24, 0, 0, 1], "D": [0, 0, 0, 0]})");
  QVERIFY(job({"k.json", "--output", "s5.json"})
              .err.contains("k does not say the size of its pictures: "));
  const QByteArray info = run({"--info", "capture"}, QDir::currentPath()).out;
  QVERIFY2(info.startsWith("cameras     2, transforms.json\ncamera      a1: 640×480 px, fx 500\n"
                           "  lens      Brown–Conrady: k1 0.1, "),
           info);
  QVERIFY2(info.contains("poses       2 of 2, at (0.1, 0.2, 6) … (0.1, 0.2, 6), in no unit"), info);
  writeFile("t.txt", "0 0 0 1 0 0 0 1\n2.5 0.1 0 1 0 0 0 1\n");
  QVERIFY(
      run({"--info", "t.txt"}, QDir::currentPath())
          .out.startsWith("trace       2 lines, 2.5 s\nplaces      (0, 0, 1) … (0.1, 0, 1) m\n"));
}

/// Of several cameras --calibration needs the name of one, and --camera a file.
void TestCameraJob::calibrationOfSeveral() {
  const QByteArray lens = R"({"K": [%, 0, 32, 0, 50, 24, 0, 0, 1], "D": [0, 0, 0, 0],
                              "img_size": [64, 48]})";
  writeFile("pair.json", R"({"left": )" + QByteArray(lens).replace("%", "50") + R"(, "right": )" +
                             QByteArray(lens).replace("%", "60") + "}");
  const auto made = [&](const QStringList& more) {
    return job(QStringList{"uniform", "--count", "1", "--output", "s2.json"} + more);
  };
  QCOMPARE(
      made({"--calibration", "pair.json"}).err,
      QByteArray("hogelscope: pair.json: has the cameras left, right: choose one with --camera "
                 "NAME\n"));
  QCOMPARE(made({"--calibration", "pair.json", "--camera", "right"}).err, QByteArray());
  QCOMPARE(loadSession("s2.json").cameras.back().intrinsics.fx, 60.0);
  QCOMPARE(
      run({"--render", "--session", "s.json", "--camera", "a", "--output", "out"},
          QDir::currentPath())
          .err,
      QByteArray("hogelscope: --camera a: needs --calibration FILE, of which it is a camera\n"));
}

/// As many as can be asked for are written, and read again.
void TestCameraJob::aHundredThousand() {
  QCOMPARE(job({"normal", "--count", "100000", "--output", "s2.json"}).err, QByteArray());
  QCOMPARE(loadSession("s2.json").cameras.size(), std::size_t(100002));
}

void TestCameraJob::mistakes_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("line");
  const auto row = [](const char* name, const QStringList& arguments, const char* line) {
    QTest::newRow(name) << arguments << QByteArray(line);
  };
  row("distribution", {"grid", "--output", "s2.json"},
      "camera set: \"grid\" is not one of uniform, random, normal, nor a file");
  row("count", {"random", "--count", "100001", "--output", "s2.json"},
      "camera set: cameraSet.count: 100001 is out of range: 1 to 1e+05");
  row("region", {"random", "--region", "sphere", "--output", "s2.json"},
      "camera set: cameraRegion.region: \"sphere\" is not one of box, plane, arc");
  row("template", {"random", "--set", "cameraSet.template=c", "--output", "s2.json"},
      "s.json: cameraSet.template: \"c\" is no state of the session");
  row("no output", {"random"},
      "--output: is missing; --make-cameras needs --output PATH, see --help make-cameras");
  row("output is a folder", {"random", "--output", "."},
      ".: cannot be written: a session's name ends in .hogelscope or .json");
}

void TestCameraJob::mistakes() {
  QFETCH(const QStringList, arguments);
  QFETCH(const QByteArray, line);
  const Outcome outcome = job(arguments);
  QCOMPARE(outcome.err, "hogelscope: " + line + "\n");
  QCOMPARE(outcome.status, 2);
  QCOMPARE(namesIn("."), (QStringList{"a.png", "s.json"}));
}

QTEST_APPLESS_MAIN(TestCameraJob)
#include "test_camera_job.moc"
