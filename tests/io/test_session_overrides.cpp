// SPDX-License-Identifier: BSD-3-Clause
// Tests --set's overrides of a session document.
#include <QTemporaryDir>
#include <QTest>

#include "io/documents/session_file.h"
#include "tests/io/documents.h"

using namespace hogelscope;

class TestSessionOverrides : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void overrides_data();
  void overrides();
  void badOverrides_data();
  void badOverrides();
  void notUtf8();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSessionOverrides::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestSessionOverrides::overrides_data() {
  QTest::addColumn<QStringList>("given");
  QTest::addColumn<QByteArray>("same");
  QTest::newRow("number") << QStringList{"sampling.samplesPerPixel=3"}
                          << text({.sampling = R"({"samplesPerPixel": 3})"});
  QTest::newRow("array") << QStringList{"display.directions=[7, 8]"}
                         << text({.display = R"({"hogels": [4, 3], "directions": [7, 8]})"});
  QTest::newRow("bare text") << QStringList{"sampling.mapping=direct"}
                             << text({.sampling = R"({"mapping": "direct"})"});
  QTest::newRow("quoted text") << QStringList{R"(sampling.mapping="direct")"}
                               << text({.sampling = R"({"mapping": "direct"})"});
  QTest::newRow("text with = and spaces")
      << QStringList{"lightField.file=a =b.png"} << text({.lightField = R"({"file": "a =b.png"})"});
  QTest::newRow("flag") << QStringList{"lightField.incoming=true"}
                        << text({.lightField = R"({"file": "scene.png", "incoming": true})"});
  QTest::newRow("every state's own")
      << QStringList{"camera.fov=45"} << text({.cameras = R"([{"name": "a", "fov": 45,
        "psf": {"sigma": 1.5, "windowSize": 9}}, {"name": "b", "fov": 45}])"});
  QTest::newRow("every state's psf, also where there was none")
      << QStringList{"psf.sigma=0.9"} << text({.cameras = R"([{"name": "a",
        "psf": {"sigma": 0.9, "windowSize": 9}}, {"name": "b", "psf": {"sigma": 0.9}}])"});
  QTest::newRow("every state's lens")
      << QStringList{"distortion.p2=-0.1"}
      << text({.cameras = R"([{"name": "a", "distortion": {"p2": -0.1},
        "psf": {"sigma": 1.5, "windowSize": 9}}, {"name": "b", "distortion": {"p2": -0.1}}])"});
  QTest::newRow("the last one counts")
      << QStringList{"display.fov=[1,1]", "sampling.samplesPerPixel=2", "display.fov=[30,40]"}
      << text({.display = R"({"hogels": [4, 3], "directions": [5, 6], "fov": [30, 40]})",
               .sampling = R"({"samplesPerPixel": 2})"});
  QTest::newRow("layout and its own fields")
      << QStringList{"lightField.layout=quilt", "lightField.columns=4", "lightField.rows=2"}
      << text({.lightField = R"({"file": "scene.png", "layout": "quilt", "columns": 4,
                                 "rows": 2})"});
}

void TestSessionOverrides::overrides() {
  QFETCH(QStringList, given);
  QFETCH(QByteArray, same);
  std::vector<std::string> list;
  for (const QString& item : given) list.push_back(item.toStdString());
  writeFile("s.json", text());
  writeFile("same.json", same);
  const Session session = loadSession("s.json", list);
  QVERIFY(session == loadSession("same.json"));
  QVERIFY(!(session == loadSession("s.json")));
}

void TestSessionOverrides::badOverrides_data() {
  QTest::addColumn<QString>("given");
  QTest::addColumn<QString>("line");
  QTest::newRow("no =") << "psf.sigma"
                        << "s.json: override psf.sigma: is not of the form section.field=value";
  QTest::newRow("no dot") << "sigma=1.5"
                          << "s.json: override sigma=1.5: is not of the form section.field=value";
  QTest::newRow("empty") << ""
                         << "s.json: override : is not of the form section.field=value";
  QTest::newRow("no such section")
      << "cameras.fov=3"
      << "s.json: override cameras.fov=3: there is no section \"cameras\": display, twin, "
         "lightField, sampling, depth, optimise, camera, intrinsics, pupil, stereo, distortion, "
         "psf";
  QTest::newRow("no such field")
      << "psf.sigmas=1"
      << "s.json: cameras[0].psf.sigmas: is not known here; did you mean \"sigma\"?";
  QTest::newRow("no such field of the display")
      << "display.foo=1"
      << "s.json: display.foo: is not known here; did you mean \"fov\"?";
  QTest::newRow("text for a number") << "psf.sigma=wide"
                                     << "s.json: cameras[0].psf.sigma: \"wide\" is not a number";
  QTest::newRow("NaN") << "camera.fov=NaN"
                       << "s.json: cameras[0].fov: \"NaN\" is not a number";
  QTest::newRow("nothing") << "camera.fov="
                           << "s.json: cameras[0].fov: \"\" is not a number";
  QTest::newRow("out of range")
      << "camera.fov=1e3"
      << "s.json: cameras[0].fov: 1000.0 is out of range: 0.01 to 179.9 °";
  QTest::newRow("unclosed list") << "camera.res=[4,4"
                                 << "s.json: cameras[0].res: \"[4,4\" is not a list of 2 numbers";
  QTest::newRow("a key twice") << R"(camera.fov={"a": 1, "a": 2})"
                               << "s.json: override camera.fov: a: stands twice in one object";
  QTest::newRow("deep") << "camera.fov=" + QString(60000, '[') + QString(60000, ']')
                        << "s.json: override camera.fov: is nested deeper than any session";
  QTest::newRow("one name for all states")
      << "camera.name=c"
      << "s.json: cameras[1].name: \"c\" is also cameras[0]; every state has a name of its own";
  QTest::newRow("another layout's field") << "lightField.shear=[1,1]"
                                          << "s.json: lightField.shear: is not known here; known "
                                             "are file, layout, incoming, viewingDistance, fps, "
                                             "frames";
}

void TestSessionOverrides::badOverrides() {
  QFETCH(QString, given);
  QFETCH(QString, line);
  writeFile("s.json", text());
  QCOMPARE(errorOf([&] { (void)loadSession("s.json", {given.toStdString()}); }), line);
}

/// The command line may have any bytes.
void TestSessionOverrides::notUtf8() {
  writeFile("s.json", text());
  const auto error = [](const std::string& given) {
    return errorOf([&] { (void)loadSession("s.json", {given}); });
  };
  QCOMPARE(error("display.kind=q\xff"),
           QString("s.json: display.kind: \"q\uFFFD\" is not one of \"hogels\", \"sheet\""));
  const QString dead = error("twin.dead.rows=\xff");
  QVERIFY2(dead.startsWith("s.json: twin.dead.rows"), qPrintable(dead));
}

QTEST_APPLESS_MAIN(TestSessionOverrides)
#include "test_session_overrides.moc"
