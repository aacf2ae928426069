// SPDX-License-Identifier: BSD-3-Clause
// Tests pupils, focus stacks and two eyes in batch mode: files, tables, reports, and one line for
// what is wrong.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/cameras/focus_stack.h"
#include "core/optics/eyes.h"
#include "core/optics/stereo_image.h"
#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/cli/views.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

const std::vector<std::string> small{"camera.res=[40,30]"};

QStringList job(const QStringList& more) {
  return QStringList{"--render", "--session", sampleSession, "--output",          "out",
                     "--states", "Fig 4",     "--set",       "camera.res=[40,30]"} +
         more;
}

/// The sample's "Fig 4" with the same changes.
Session changed(std::vector<std::string> changes) {
  changes.insert(changes.begin(), small.begin(), small.end());
  Session session = loadSession(sampleSession.toStdString(), changes);
  std::erase_if(session.cameras,
                [](const CameraState& state) { return state.camera.name != "Fig 4"; });
  return session;
}

/// Whether the picture is the reference engine's, but for sums near a rounding half.
bool shows(const QString& file, const Image& expected) {
  const auto values = valuesOf<std::uint8_t>(file);
  if (values.size() != expected.rgb.size()) return false;
  int apart = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const int difference = std::abs(int(values[k]) - int(expected.rgb[k]));
    if (difference > 1) return false;
    apart += difference;
  }
  return apart < 20;
}

}  // namespace

class TestEyes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void pupilsAreRendered();
  void pinholesStayAsTheyWere();
  void explainsTheSamples();
  void warnsOfTooManySamples();
  void focusStack();
  void bothEyes();
  void joinedPictures_data();
  void joinedPictures();
  void focusStackOfBothEyes();
  void reportHasARowForEachEye();
  void largeLightFieldsAreTheSame();
  void cameraSetsKeepThem();
  void documentsKeepThem();
  void refusals_data();
  void refusals();

 private:
  Outcome render(const QStringList& more) { return run(job(more), m_folder->path()); }
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestEyes::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestEyes::pupilsAreRendered() {
  const Outcome outcome = render({"--masks", "--set", "pupil.diameter=0.02", "--set",
                                  "pupil.focus=0.4", "--set", "pupil.samples=9"});
  QCOMPARE(outcome.err, QByteArray());
  const Session session = changed({"pupil.diameter=0.02", "pupil.focus=0.4", "pupil.samples=9"});
  const Image expected = simulated(session).front();
  QVERIFY(shows("out/Fig 4.png", expected));
  QVERIFY(valuesOf<std::uint8_t>("out/Fig 4.mask.png") == expected.seen);
  QVERIFY(expected.rgb != simulated(changed({})).front().rgb);
}

void TestEyes::pinholesStayAsTheyWere() {
  QCOMPARE(render({}).status, 0);
  const auto before = valuesOf<std::uint8_t>("out/Fig 4.png");
  QCOMPARE(render({"--set", "pupil.focus=0.3", "--set", "pupil.samples=50"}).status, 0);
  QVERIFY(valuesOf<std::uint8_t>("out/Fig 4.png") == before);
  QCOMPARE(render({"--set", "pupil.diameter=1e-6"}).status, 0);
  QVERIFY(valuesOf<std::uint8_t>("out/Fig 4.png") == before);
}

void TestEyes::explainsTheSamples() {
  const QByteArray many = render({"--explain", "--set", "pupil.diameter=0.05"}).out;
  const Session session = changed({"pupil.diameter=0.05"});
  const ViewSource source = loadViewSource(session, {});
  const Aperture aperture =
      apertureOf(session.cameras[0].pupil, session.cameras[0].camera, source.display);
  QVERIFY2(many.contains(QByteArray::number(int(aperture.points.size())) +
                         " samples of the pupil, focused at 0.559 m: as many as the display needs"),
           many);
  const QByteArray none = render({"--explain", "--set", "pupil.diameter=1e-4"}).out;
  QVERIFY2(none.contains("a pinhole: the pupil changes nothing"), none);
  QVERIFY(!render({"--explain"}).out.contains("pupil"));
}

void TestEyes::warnsOfTooManySamples() {
  const QByteArray warning =
      run({"--render", "--session", sampleSession, "--output", "out", "--states", "Fig 4", "--set",
           "camera.res=[4,4]", "--set", "pupil.diameter=0.9", "--set", "pupil.focus=0.2"},
          m_folder->path())
          .err;
  QVERIFY2(warning.contains("warning: Fig 4: pupil: the display needs ") &&
               warning.contains(" samples; 4096 are taken"),
           warning);
}

void TestEyes::focusStack() {
  const Outcome outcome = render({"--focus-stack", "3", "--set", "pupil.diameter=0.02"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.out, QByteArray("3 picture(s) in out\n"));
  QCOMPARE(namesIn("out"), (QStringList{"Fig 4.focus.csv", "Fig 4.focus01.png", "Fig 4.focus02.png",
                                        "Fig 4.focus03.png"}));
  const QList<QStringList> table = tableOf("out/Fig 4.focus.csv");
  QCOMPARE(table[0], (QStringList{"file", "focus", "dioptres"}));
  // The sharp depths are p/(s D²) dioptres before and behind the panel, cut at 10 m.
  const double step = 2 * std::tan(30 * 3.14159265358979 / 180) / 20;
  const double panel = 1 / 0.559;
  const double half = 0.5 / 32 / (step * 0.559 * 0.559);
  Session session = changed({"pupil.diameter=0.02"});
  for (int k = 0; k < 3; ++k) {
    const double first = std::min(panel + half, 10.0);
    const double dioptres = first + (std::max(panel - half, 0.1) - first) * k / 2;
    QCOMPARE(table[k + 1][0], QString("Fig 4.focus0%1.png").arg(k + 1));
    QVERIFY(std::abs(table[k + 1][2].toDouble() - dioptres) < 1e-9);
    QVERIFY(std::abs(table[k + 1][1].toDouble() * dioptres - 1) < 1e-9);
    session.cameras[0].pupil.focus = table[k + 1][1].toDouble();
    QVERIFY(shows("out/" + table[k + 1][0], simulated(session).front()));
  }
}

void TestEyes::bothEyes() {
  QCOMPARE(render({"--masks", "--set", "stereo.ipd=0.06"}).status, 0);
  QCOMPARE(namesIn("out"), (QStringList{"Fig 4.left.mask.png", "Fig 4.left.png",
                                        "Fig 4.right.mask.png", "Fig 4.right.png"}));
  const std::vector<Image> expected = simulated(withEyes(changed({"stereo.ipd=0.06"})));
  QVERIFY(shows("out/Fig 4.left.png", expected[0]) && shows("out/Fig 4.right.png", expected[1]));
  QVERIFY(expected[0].rgb != expected[1].rgb);
}

void TestEyes::joinedPictures_data() {
  QTest::addColumn<StereoMode>("mode");
  for (std::size_t k = 0; k < stereoModeNames().size(); ++k)
    QTest::newRow(stereoModeNames()[k].data()) << static_cast<StereoMode>(k);
}

void TestEyes::joinedPictures() {
  QFETCH(const StereoMode, mode);
  const QString name = QTest::currentDataTag();
  QCOMPARE(render({"--masks", "--set", "stereo.ipd=0.06", "--stereo", name}).status, 0);
  QCOMPARE(namesIn("out"),
           (QStringList{"Fig 4.left.mask.png", "Fig 4.png", "Fig 4.right.mask.png"}));
  const std::vector<Image> eyes = simulated(withEyes(changed({"stereo.ipd=0.06"})));
  QVERIFY(shows("out/Fig 4.png", stereoImage(eyes[0], eyes[1], mode)));
}

void TestEyes::focusStackOfBothEyes() {
  const QStringList changes{"--focus-stack",       "2",     "--set",
                            "pupil.diameter=0.02", "--set", "stereo.ipd=0.06"};
  QCOMPARE(render(changes).status, 0);
  QCOMPARE(namesIn("out"),
           (QStringList{"Fig 4.focus.csv", "Fig 4.left.focus01.png", "Fig 4.left.focus02.png",
                        "Fig 4.right.focus01.png", "Fig 4.right.focus02.png"}));
  QCOMPARE(tableOf("out/Fig 4.focus.csv").size(), 5);
  QVERIFY(QDir("out").removeRecursively());
  QCOMPARE(render(changes + QStringList{"--stereo", "anaglyph"}).status, 0);
  QCOMPARE(namesIn("out"),
           (QStringList{"Fig 4.focus.csv", "Fig 4.focus01.png", "Fig 4.focus02.png"}));
}

void TestEyes::reportHasARowForEachEye() {
  const QStringList report{"--report", "--session", sampleSession,
                           "--output", "out",       "--states",
                           "Fig [45]", "--test",    HOGELSCOPE_SOURCE_DIR "/tests/data/scene.png",
                           "--images", "--set",     "camera.res=[40,30]",
                           "--quiet"};
  QCOMPARE(run(report + QStringList{"--set", "stereo.ipd=0.06"}, m_folder->path()).err,
           QByteArray());
  QStringList names;
  for (const QStringList& row : tableOf("out/report.csv").mid(1)) names << row[0];
  QCOMPARE(names, (QStringList{"Fig 4/left", "Fig 4/right", "Fig 5/left", "Fig 5/right"}));
  const QList<QStringList> metrics = tableOf("out/metrics.csv");
  const auto weight = metrics[0].indexOf("weight");
  QVERIFY(weight > 0);
  for (const QStringList& row : metrics.mid(1)) QCOMPARE(row[weight], QString("0.5"));
  QCOMPARE(namesIn("out/reference"),
           (QStringList{"Fig 4.left.png", "Fig 4.right.png", "Fig 5.left.png", "Fig 5.right.png"}));
}

/// In memory, read once from the top, and in a store that is read piece by piece.
void TestEyes::largeLightFieldsAreTheSame() {
  const QString session = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/data/table1.json");
  const QStringList pictures{"--render",
                             "--states",
                             "Fig [34]",
                             "--set",
                             "camera.res=[50,40]",
                             "--set",
                             "pupil.diameter=0.03",
                             "--set",
                             "pupil.focus=0.4",
                             "--set",
                             "stereo.ipd=0.06",
                             "--masks",
                             "--quiet"};
  const auto rendered = [&](const QStringList& more, const QString& folder) {
    const Outcome outcome =
        run(pictures + more + QStringList{"--output", folder}, m_folder->path());
    if (outcome.status != 0) qFatal("%s", outcome.err.constData());
    QList<std::vector<std::uint8_t>> all;
    for (const QString& name : namesIn(folder)) all << valuesOf<std::uint8_t>(folder + "/" + name);
    return all;
  };
  const auto whole = rendered({"--session", session}, "whole");
  QCOMPARE(whole.size(), 8);
  QVERIFY(rendered({"--session", session, "--memory", "12"}, "streamed") == whole);
  QCOMPARE(run({"--pack", HOGELSCOPE_SOURCE_DIR "/data/scene.png", "--session", session, "--output",
                "store.tif", "--quiet"},
               m_folder->path())
               .err,
           QByteArray());
  QVERIFY(
      rendered({"--session", session, "--set", "lightField.file=" + m_folder->filePath("store.tif"),
                "--set", "lightField.layout=pack", "--memory", "12"},
               "store") == whole);
}

/// The states of a set and of a trace are heads.
void TestEyes::cameraSetsKeepThem() {
  QCOMPARE(run({"--make-cameras", "random", "--session", sampleSession, "--count", "3", "--set",
                "stereo.ipd=0.06", "--set", "pupil.diameter=0.004", "--output", "set.json"},
               m_folder->path())
               .status,
           0);
  for (const CameraState& state : loadSession("set.json").cameras)
    QVERIFY(state.stereo.ipd == 0.06 && state.pupil.diameter == 0.004);
}

void TestEyes::documentsKeepThem() {
  QCOMPARE(render({"--set", "pupil.diameter=0.004", "--set", "stereo.ipd=0.063", "--save-session",
                   "kept.json"})
               .status,
           0);
  const Session kept = loadSession("kept.json");
  QCOMPARE(kept.cameras.size(), std::size_t(1));
  QCOMPARE(kept.cameras[0].pupil, (PupilParams{0.004, 0, 0}));
  QCOMPARE(kept.cameras[0].stereo, (StereoParams{0.063}));
  QCOMPARE(render({"--save-session", "plain.json"}).status, 0);
  QFile plain("plain.json");
  QVERIFY(plain.open(QIODevice::ReadOnly));
  const QByteArray text = plain.readAll();
  QVERIFY(!text.contains("pupil") && !text.contains("stereo"));
}

void TestEyes::refusals_data() {
  QTest::addColumn<QStringList>("more");
  QTest::addColumn<QByteArray>("says");
  const auto set = [](const QString& change) { return QStringList{"--set", change}; };
  QTest::newRow("diameter") << set("pupil.diameter=-0.001") << QByteArray("pupil.diameter");
  QTest::newRow("focus") << set("pupil.focus=-1") << QByteArray("pupil.focus");
  QTest::newRow("samples") << set("pupil.samples=4097") << QByteArray("pupil.samples");
  QTest::newRow("ipd") << set("stereo.ipd=-0.06") << QByteArray("stereo.ipd");
  QTest::newRow("not a number") << set("pupil.diameter=null") << QByteArray("pupil.diameter");
  QTest::newRow("beside the panel")
      << QStringList{"--set", "pupil.diameter=0.004", "--set", "camera.lookat=[9,0,0.559]"}
      << QByteArray("pupil.focus: is 0, on the panel, whose plane the camera's axis does not meet");
  QTest::newRow("stack of a pinhole")
      << QStringList{"--focus-stack", "3"} << QByteArray("pupil.diameter: is 0, a pinhole");
  QTest::newRow("stack of one") << QStringList{"--focus-stack", "1", "--set",
                                               "pupil.diameter=0.004"}
                                << QByteArray("--focus-stack: \"1\" is not a number from 2");
  QTest::newRow("one eye") << QStringList{"--stereo", "anaglyph"}
                           << QByteArray("--stereo anaglyph: needs two eyes");
  QTest::newRow("video of two") << QStringList{"--video", "v.mp4", "--set", "stereo.ipd=0.06"}
                                << QByteArray("--video: has one picture for both eyes");
  QTest::newRow("slash") << set("camera.name=a/left") << QByteArray("has a slash");
}

void TestEyes::refusals() {
  QFETCH(const QStringList, more);
  QFETCH(const QByteArray, says);
  const Outcome outcome = render(more);
  QCOMPARE(outcome.status, 2);
  QVERIFY2(outcome.err.contains(says) && outcome.err.count('\n') == 1, outcome.err);
  QVERIFY(namesIn(".").isEmpty());
}

QTEST_APPLESS_MAIN(TestEyes)
#include "test_eyes.moc"
