// SPDX-License-Identifier: BSD-3-Clause
// Tests the measured hogel lens: its curve, pictures through it, sessions, and what is wrong with
// tables.
#include <sys/stat.h>

#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/optics/simulate.h"
#include "core/panel/viewing_zone.h"
#include "io/documents/session_file.h"
#include "io/plugins/display_json.h"
#include "io/store/store_header.h"
#include "tests/cli/program.h"
#include "tests/core/random_scene.h"
#include "tests/core/rendered.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

constexpr double perDegree = 3.14159265358979323846 / 180;

/// What a lens was measured to do; it is tilted by some degrees.
const QByteArray tilted =
    "direction,angle\n-0.5,-31\n-0.41,-26.5\n-0.2,-12\n0.02,1.5\n0.05,4\n0.3,17.5\n0.5,27\n";

/// A lens that spaces directions evenly in angle.
QByteArray evenTable(double fov) {
  QByteArray table = "direction,angle\r\n";
  for (int k = -6; k <= 6; ++k)
    table += QByteArray::number(k / 12.0, 'g', 17) + ", " +
             QByteArray::number(k / 12.0 * fov, 'g', 17) + "\r\n";
  return table;
}

PanelParams displayWith(const QByteArray& table, std::array<double, 2> fov) {
  writeFile("lens.csv", table);
  PanelParams display;
  display.fov = fov;
  display.lens = HogelLensModel::plugin;
  display.lensSource = "measured-lens";
  display.lensParams = lensParamsOf("measured-lens");
  display.lensParams.set("file", std::string("lens.csv"));
  return display;
}

}  // namespace

class TestMeasuredLens : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void curveOfScipy();
  void inverse();
  void evenInAngle();
  void enginesAgree();
  void axes();
  void withoutTable();
  void aPipeIsNoTable();
  void viewingZone();
  void isReadOnce();
  void inSessions();
  void anotherTableIsAnotherReport();
  void mistakes_data();
  void mistakes();
  void mistakesOfSessions_data();
  void mistakesOfSessions();

 private:
  QTemporaryDir m_folder;
};

void TestMeasuredLens::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
}

/// The figures are those of measured_lens.py.
void TestMeasuredLens::curveOfScipy() {
  const auto lens = lensOf(displayWith(tilted, {58, 58}), 0);
  const std::vector<std::pair<double, double>> known{
      {-30.9, -0.497869172759184}, {-28, -0.437754560682797}, {-26.5, -0.41},
      {-20, -0.311706315258611},   {-5, -0.0823303179902451}, {0, -0.00110175804700399},
      {1, 0.0131976176354375},     {2.2, 0.0286267059349764}, {4.1, 0.0513942685389131},
      {10, 0.150662116601865},     {20, 0.350393873542885},   {26.9, 0.497790931190993}};
  for (const auto& [angle, direction] : known)
    QVERIFY2(std::abs(lens->directionOf(std::tan(angle * perDegree)) - direction) < 1e-13,
             qPrintable(QString::number(angle)));
}

void TestMeasuredLens::inverse() {
  const auto lens = lensOf(displayWith(tilted, {58, 58}), 1);
  Random random(3);
  double last = -HUGE_VAL;
  for (int k = 0; k < 2000; ++k) {
    const double direction = random.uniform(-0.5, 0.5);
    QVERIFY(std::abs(lens->directionOf(lens->slopeOf(direction)) - direction) < 1e-13);
  }
  for (int k = -2000; k <= 2000; ++k) {  // far beyond the field, too
    const double direction = lens->directionOf(k / 100.0);
    QVERIFY(direction > last);
    last = direction;
  }
  QVERIFY(lens->directionOf(std::tan(-31.01 * perDegree)) < -0.5);
  QVERIFY(lens->directionOf(std::tan(27.01 * perDegree)) > 0.5);
}

/// The program's own equiangular lens is the independent implementation.
void TestMeasuredLens::evenInAngle() {
  Random random(11);
  int seen = 0;
  for (int repeat = 0; repeat < 40; ++repeat) {
    RandomScene scene = randomScene(random);
    RenderJob& job = scene.job;
    const double fov = random.uniform(20, 120);
    job.display.fov = {fov, fov};
    job.display.lens = HogelLensModel::equiangular;
    const Image expected = rendered(job);
    PanelParams measured = displayWith(evenTable(fov), {fov, fov});
    job.display.lens = measured.lens;
    job.display.lensSource = measured.lensSource;
    job.display.lensParams = measured.lensParams;
    const Image image = rendered(job);
    QCOMPARE(image.seen, expected.seen);
    QCOMPARE(image.rgb, expected.rgb);
    seen += int(std::count(image.seen.begin(), image.seen.end(), 255));
  }
  QVERIFY(seen > 1000);
}

/// The fast engine against the reference engine, with a tilted lens.
void TestMeasuredLens::enginesAgree() {
  Random random(12);
  const PanelParams measured = displayWith(tilted, {58, 58});
  for (int repeat = 0; repeat < 40; ++repeat) {
    RandomScene scene = randomScene(random);
    RenderJob& job = scene.job;
    job.display.fov = measured.fov;
    job.display.lens = measured.lens;
    job.display.lensSource = measured.lensSource;
    job.display.lensParams = measured.lensParams;
    const Image expected = simulate(job);
    const Image image = rendered(job);
    QCOMPARE(image.seen, expected.seen);
    for (std::size_t k = 0; k < image.rgb.size(); ++k)
      QVERIFY(std::abs(int(image.rgb[k]) - int(expected.rgb[k])) <= 1);  // sums in another order
  }
}

/// Of one field, but with tables of their own.
void TestMeasuredLens::axes() {
  writeFile("down.csv", "direction,angle\n-0.5,-20\n0,-4\n0.5,38\n");
  PanelParams display = displayWith(tilted, {58, 58});
  display.lensParams.set("fileDown", std::string("down.csv"));
  display.hogels = display.directions = {10, 10};
  const Display shown(display);
  // u grows to the right, v downwards: v = 0 is the light that goes farthest up.
  QVERIFY(std::abs(shown.slopes(0, 0).x - std::tan(-31 * perDegree)) < 1e-12);
  QVERIFY(std::abs(shown.slopes(0, 0).y - std::tan(38 * perDegree)) < 1e-12);
  QVERIFY(std::abs(shown.slopes(5, 5).y - std::tan(-4 * perDegree)) < 1e-12);
  QCOMPARE(display.lensParams.files(), (std::vector<std::string>{"lens.csv", "down.csv"}));
}

void TestMeasuredLens::withoutTable() {
  PanelParams display = displayWith(tilted, {70, 40});
  display.lensParams.set("file", std::string());
  const auto rectilinear = makeHogelLens(HogelLensModel::rectilinear, 40);
  const auto lens = lensOf(display, 1);
  for (const double at : {-0.5, -0.2, 0.0, 0.31}) {
    QCOMPARE(lens->slopeOf(at), rectilinear->slopeOf(at));
    QCOMPARE(lens->directionOf(at), rectilinear->directionOf(at));
  }
}

/// Nobody writes into it, so that reading would not end.
void TestMeasuredLens::aPipeIsNoTable() {
  PanelParams display = displayWith(tilted, {58, 58});
  QCOMPARE(::mkfifo("pipe.csv", 0600), 0);
  display.lensParams.set("file", std::string("pipe.csv"));
  QVERIFY(errorOf([&] { (void)lensOf(display, 0); }).contains("pipe.csv: cannot be read"));
}

/// A lens that looks to one side lights other points than one that looks straight ahead.
void TestMeasuredLens::viewingZone() {
  PanelParams display = displayWith("direction,angle\n-0.5,10\n0.5,50\n", {40, 40});
  display.size = {0.01, 0.01};
  const double middle = std::tan(30 * perDegree);
  QVERIFY(shareSeenFrom(display, {middle, middle, 1}) == 1);
  QVERIFY(shareSeenFrom(display, {0, 0, 1}) == 0);
  QVERIFY(shareSeenFrom(display, {-middle, -middle, 1}) == 0);
}

void TestMeasuredLens::isReadOnce() {
  const PanelParams display = displayWith(tilted, {58, 58});
  const auto before = lensOf(display, 0);
  writeFile("lens.csv", "direction,angle\n-0.5,-29\n0.5,29\n");
  QCOMPARE(lensOf(display, 0), before);
  const PanelParams copy = display;
  QCOMPARE(lensOf(copy, 0), before);
  QVERIFY(lensOf(displayWith(tilted, {58, 58}), 0) != before);
}

void TestMeasuredLens::inSessions() {
  QDir().mkdir("folder");
  writeFile("folder/lens.csv", tilted);
  writeFile("folder/s.json", R"({"hogelscope": 1,
    "display": {"hogels": [8, 8], "directions": [8, 8], "fov": [58, 58], "lens": "plugin",
                "lensSource": "measured-lens", "measured-lens": {"file": "lens.csv"}},
    "lightField": {"layout": "live", "source": "scene"},
    "cameras": [{"name": "a", "eye": [0, 0, 1]}]})");
  const Session session = loadSession("folder/s.json");
  QCOMPARE(*session.display.lensParams.find<std::string>("file"), std::string("folder/lens.csv"));
  saveSession("t.json", session);
  QVERIFY(contentOf("t.json").contains("\"file\": \"folder/lens.csv\""));
  QVERIFY(loadSession("t.json").display == session.display);
  const Session other =
      loadSession("folder/s.json", {"display.measured-lens.file=", "display.fov=[70,70]"});
  QVERIFY(other.display != session.display);
  QCOMPARE(lensOf(other.display, 0)->slopeOf(0.5), std::tan(35 * perDegree));
}

/// A report goes on with the same table, and begins anew with another.
void TestMeasuredLens::anotherTableIsAnotherReport() {
  const auto report = [&](const QString& output) {
    return run({"--report", "--session", sampleSession, "--states", "Fig 1", "--test",
                HOGELSCOPE_SOURCE_DIR "/tests/data/scene.png", "--output", output, "--set",
                "camera.res=[40,40]", "--set", "display.fov=[58,58]", "--set",
                "display.lens=plugin", "--set", "display.lensSource=measured-lens", "--set",
                "display.measured-lens.file=" + m_folder.path() + "/lens.csv"},
               m_folder.path());
  };
  writeFile("lens.csv", tilted);
  QVERIFY(QDir().mkpath("half/report.html"));  // the page cannot replace it
  QCOMPARE(report("half").status, 2);
  QVERIFY(QDir().rmdir("half/report.html"));
  QVERIFY(QDir().mkpath("other"));
  QVERIFY(QFile::copy("half/report.journal", "other/report.journal"));
  const Outcome same = report("half");
  QVERIFY2(same.err.contains("went on after 1 view"), same.err);
  QVERIFY(contentOf("half/report.html").contains("lenses of the plugin measured-lens"));
  writeFile("lens.csv", "direction,angle\n-0.5,-29\n0.5,29\n");
  const Outcome other = report("other");
  QVERIFY2(other.err.contains("was of another report"), other.err);
}

void TestMeasuredLens::mistakes_data() {
  QTest::addColumn<QByteArray>("table");
  QTest::addColumn<QByteArray>("message");
  const QByteArray head = "direction,angle\n";
  QTest::newRow("empty") << QByteArray() << QByteArray("has fewer than two rows");
  QTest::newRow("one row") << head + "-0.5,-29\n" << QByteArray("has fewer than two rows");
  QTest::newRow("no columns") << QByteArray("-0.5,-29\n0.5,29\n")
                              << QByteArray("begins with another line than its columns");
  QTest::newRow("words") << head + "-0.5,-29\nmiddle,0\n"
                         << QByteArray("line 3 is not two numbers");
  QTest::newRow("one number") << head + "-0.5\n" << QByteArray("line 2 is not two numbers");
  QTest::newRow("more numbers") << head + "-0.5,-29,1\n" << QByteArray("line 2 is not two");
  QTest::newRow("NaN") << head + "-0.5,-29\n0,nan\n0.5,29\n" << QByteArray("line 3 is not two");
  QTest::newRow("infinite") << head + "-0.5,-29\n0,1e999\n0.5,29\n"
                            << QByteArray("line 3 is not two");
  QTest::newRow("order") << head + "-0.5,-29\n0.5,29\n0,0\n" << QByteArray("row 3 does not grow");
  QTest::newRow("mirrored") << head + "-0.5,29\n0.5,-29\n" << QByteArray("row 2 does not grow");
  QTest::newRow("twice") << head + "-0.5,-29\n-0.5,-29\n0.5,29\n"
                         << QByteArray("row 2 does not grow");
  QTest::newRow("not to its ends") << head + "-0.4,-29\n0.5,29\n"
                                   << QByteArray("its directions reach from -0.4 to 0.5");
  QTest::newRow("beyond the panel") << head + "-0.5,-91\n0.5,29\n"
                                    << QByteArray("has an angle of 90° or more");
  QTest::newRow("another field") << head + "-0.5,-29\n0.5,30\n"
                                 << QByteArray(
                                        "its angles span 59°: set display.fov to this "
                                        "across, not 58");
  QTest::newRow("rows") << head + QByteArray("-0.5,-29\n").repeated(10001)
                        << QByteArray("has more than 10000 rows");
  QTest::newRow("long") << head + QByteArray(1000001, ' ') << QByteArray("has more than 1 MB");
  QTest::newRow("binary") << head + QByteArray(100, '\0') << QByteArray("line 2 is not two");
}

void TestMeasuredLens::mistakes() {
  QFETCH(QByteArray, table);
  QFETCH(QByteArray, message);
  const PanelParams display = displayWith(table, {58, 58});
  const QByteArray wanted = "plugin measured-lens: lens.csv: " + message;
  try {
    (void)lensOf(display, 0);
    QFAIL("throws nothing");
  } catch (const InputError& error) {
    QVERIFY2(QByteArray(error.what()).startsWith(wanted), error.what());
  }
}

void TestMeasuredLens::mistakesOfSessions_data() {
  QTest::addColumn<QByteArray>("display");
  QTest::addColumn<QByteArray>("message");
  QTest::newRow("no name") << QByteArray(R"("lens": "plugin")")
                           << QByteArray("display.lensSource: is missing");
  QTest::newRow("unknown") << QByteArray(R"("lens": "plugin", "lensSource": "fish-eye")")
                           << QByteArray("fish-eye");
  QTest::newRow("another kind") << QByteArray(R"("lens": "plugin", "lensSource": "example")")
                                << QByteArray("plugin example: ");
  QTest::newRow("another lens") << QByteArray(R"("lensSource": "measured-lens")")
                                << QByteArray("display.lensSource: is not known");
  QTest::newRow("field") << QByteArray(R"("lens": "plugin", "lensSource": "measured-lens",
                                          "measured-lens": {"table": "x"})")
                         << QByteArray("display.measured-lens.table: ");
  QTest::newRow("file") << QByteArray(R"("lens": "plugin", "lensSource": "measured-lens",
                                         "measured-lens": {"file": "none.csv"})")
                        << QByteArray("plugin measured-lens: none.csv: cannot be read");
  QTest::newRow("folder") << QByteArray(R"("lens": "plugin", "lensSource": "measured-lens",
                                           "measured-lens": {"file": "."})")
                          << QByteArray("cannot be read");
}

void TestMeasuredLens::mistakesOfSessions() {
  QFETCH(QByteArray, display);
  QFETCH(QByteArray, message);
  writeFile("wrong.json",
            R"({"hogelscope": 1, "display": {"hogels": [8, 8], "directions": [8, 8], )" + display +
                R"(}, "lightField": {"layout": "live", "source": "scene"},
    "cameras": [{"name": "a", "eye": [0, 0, 1]}]})");
  try {
    (void)loadSession("wrong.json");
    QFAIL("throws nothing");
  } catch (const InputError& error) {
    QVERIFY2(QByteArray(error.what()).startsWith("wrong.json: "), error.what());
    QVERIFY2(QByteArray(error.what()).contains(message), error.what());
  }
}

QTEST_GUILESS_MAIN(TestMeasuredLens)
#include "test_measured_lens.moc"
