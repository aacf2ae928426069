// SPDX-License-Identifier: BSD-3-Clause
// Tests lens sheets as a user meets them: a calibration and a quilt, what an eye sees, the panel's
// picture, and what is refused.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

namespace {

constexpr int views = 6;
constexpr double distance = 0.6;
constexpr double tangent = 0.36397023;  // of half the cone

const QByteArray calibration = R"({"serial": "test", "pitch": {"value": 5.0}, "slope": -6.0,
    "center": 0.1, "viewCone": 40, "DPI": 50, "screenW": 180, "screenH": 120})";

QByteArray session(const QByteArray& sheet = R"("calibration": "visual.json")",
                   const QByteArray& more = "", const QByteArray& layout = "quilt") {
  QByteArray states;
  for (int k = 0; k < views; ++k) {
    const double x = ((k + 0.5) / views - 0.5) * 2 * distance * tangent;
    states += QString(R"(%1{"name": "%2", "eye": [%3, 0, 0.6], "fov": 4, "res": [80, 60]})")
                  .arg(k == 0 ? "" : ", ")
                  .arg(k)
                  .arg(x, 0, 'f', 9)
                  .toUtf8();
  }
  return R"({"hogelscope": 1, "display": {"kind": "sheet", )" + sheet + "}, " + more +
         R"("lightField": {"file": "q_qs6x1a1.5.png", "layout": ")" + layout +
         R"("}, "cameras": [)" + states + "]}";
}

}  // namespace

class TestSheet : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void eachEyeSeesItsView();
  void panelIsWoven();
  void sessionKeepsItsCalibration();
  void reports();
  void mistakes_data();
  void mistakes();

 private:
  Outcome program(const QStringList& arguments) { return run(arguments, m_folder->path()); }
  std::unique_ptr<QTemporaryDir> m_folder;
};

/// Views of 30×20 pixels, each of one grey.
void TestSheet::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeFile("visual.json", calibration);
  writeFile("s.json", session());
  writeImageFile("q_qs6x1a1.5.png", 30 * views, 20,
                 [](int x, int, int) { return float(40 * (x / 30)) / 255; });
}

void TestSheet::eachEyeSeesItsView() {
  const Outcome outcome = program({"--render", "--session", "s.json", "--output", "out"});
  QCOMPARE(outcome.err, QByteArray());
  for (int k = 0; k < views; ++k) {
    const QImage image(QString("out/%1.png").arg(k));
    QCOMPARE(image.size(), QSize(80, 60));
    // A sub-pixel is small beside a view, so that all of them show one.
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 80; ++x) QCOMPARE(image.pixel(x, y), qRgb(40 * k, 40 * k, 40 * k));
  }
}

/// Each sub-pixel has the view that its phase says, at the view's own place.
void TestSheet::panelIsWoven() {
  writeImageFile("q_qs6x1a1.5.png", 30 * views, 20, [](int x, int y, int c) {
    return float(40 * (x / 30) + x % 30 + (c == 2 ? y : 0)) / 255;
  });
  const Outcome outcome =
      program({"--export", "woven", "--session", "s.json", "--output", "panel/woven.png"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.out, QByteArray("panel/woven.png: woven\n"));
  const QImage image("panel/woven.png");
  QCOMPARE(image.size(), QSize(180, 120));
  const double q = 0.0254 / 50;
  const double p = 0.0254 / 5 / std::cos(std::atan(1.0 / 6));
  const double lenses = 180 * q / p;
  const double phase = lenses * (1 - 120.0 / (180 * 6)) / 2 - 0.1;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 180; ++x)
      for (int c = 0; c < 3; ++c) {
        const double right = (x + 0.5 + c / 3.0 - 90) * q;
        const double up = (119 - y + 0.5 - 60) * q;
        const double turns = (right - up / 6) / p + phase;
        const int view = int(views * (1 - (turns - std::floor(turns))));
        const int law = 40 * view + x / 6 + (c == 2 ? y / 6 : 0);
        const QRgb colour = image.pixel(x, y);
        QCOMPARE((std::array{qRed(colour), qGreen(colour), qBlue(colour)}[std::size_t(c)]), law);
      }
}

void TestSheet::sessionKeepsItsCalibration() {
  QCOMPARE(program({"--render", "--session", "s.json", "--output", "a", "--states", "2",
                    "--save-session", "sub/kept.json"})
               .status,
           0);
  QVERIFY(contentOf("sub/kept.json").contains("\"calibration\": \"../visual.json\""));
  QCOMPARE(program({"--render", "--session", "sub/kept.json", "--output", "b"}).status, 0);
  QCOMPARE(contentOf("b/2.png"), contentOf("a/2.png"));
  // Overridden, it stands in the session.
  QCOMPARE(program({"--render", "--session", "s.json", "--output", "c", "--states", "2", "--set",
                    "display.calibration.cone=20", "--save-session", "other.json"})
               .status,
           0);
  QVERIFY(contentOf("other.json").contains("\"cone\": 20.0"));
  QVERIFY(contentOf("c/2.png") != contentOf("a/2.png"));
  QCOMPARE(program({"--render", "--session", "other.json", "--output", "d"}).status, 0);
  QCOMPARE(contentOf("d/2.png"), contentOf("c/2.png"));
}

/// Another quilt is woven for the same panel.
void TestSheet::reports() {
  QVERIFY(QFile::copy("q_qs6x1a1.5.png", "other_qs6x1a1.5.png"));
  QCOMPARE(program({"--report", "--session", "s.json", "--test", "other_qs6x1a1.5.png", "--output",
                    "report", "--quiet"})
               .status,
           0);
  const auto table = tableOf("report/report.csv");
  QCOMPARE(table.size(), views + 1);
  QCOMPARE(table[1][table[0].indexOf("mse")].toDouble(), 0.0);
}

void TestSheet::mistakes_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("document");
  QTest::addColumn<QByteArray>("line");
  const QStringList render{"--render", "--session", "s.json", "--output", "out"};
  const auto row = [](const QStringList& arguments, const QByteArray& document,
                      const QByteArray& line) {
    QTest::newRow(line.constData()) << arguments << document << line;
  };
  const QByteArray own = R"("calibration": "visual.json")";
  row(render, session(R"("calibration": "none.json")"), "none.json: cannot be read: …");
  row(render, session(R"("emitter": [1, 1])"),
      "s.json: display.calibration: is missing: name the sheet's visual.json");
  row(render, session(R"("calibration": {"pitch": 5})"),
      "s.json: display.calibration.slope: is missing");
  row(render, session(R"("calibration": {"pitsch": 5})"), "s.json: display.calibration.pitsch: …");
  row(render, session(own + R"(, "fov": [40, 40])"),
      "s.json: display.fov: is for a display of hogels: a lens sheet's calibration says it");
  row(render, session(own + R"(, "viewingDistance": -1)"), "s.json: display.viewingDistance: …");
  row(render, session(own).replace("\"sheet\"", "\"sheep\""),
      "s.json: display.kind: \"sheep\" is not one of \"hogels\", \"sheet\"");
  row(render, session(own, "", "hogels"),
      "s.json: lightField.layout: must be \"quilt\" for a lens sheet");
  row(render, session(own, R"("twin": {"light": {"bits": 6}}, )"),
      "s.json: twin: is for a display of hogels, not for a lens sheet");
  row(render, session(own, R"("sampling": {"reconstruction": "bilinear"}, )"),
      "s.json: sampling.reconstruction: must be \"nearest\" for a lens sheet, whose pixels are not "
      "interpolated");
  row(render + QStringList{"--set", "psf.windowSize=3"}, session(),
      "s.json: cameras[0].psf.windowSize: must be 1 for a lens sheet, whose pixels have no "
      "directions to leak into");
  row({"--measure", "--session", "s.json", "--output", "out"}, session(),
      "s.json: display.kind: is \"sheet\", which --measure does not know");
  row({"--export", "pack", "--session", "s.json", "--output", "out.tif"}, session(),
      "s.json: display.kind: is \"sheet\", which --export pack does not know");
  row(render + QStringList{"--save-session", "visual.json"}, session(),
      "visual.json: cannot be written: it is visual.json, which is read: choose another name");
  row({"--export", "views", "--session", "s.json", "--output", "out"}, session(),
      "--export views: is for a display of hogels: give woven for a lens sheet");
}

void TestSheet::mistakes() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, document);
  QFETCH(QByteArray, line);
  writeFile("s.json", document);
  const Outcome outcome = program(arguments);
  QCOMPARE(outcome.status, 2);
  compareLine(outcome.err.chopped(1), "hogelscope: " + line);
  QVERIFY(!QFileInfo::exists("out"));
}

QTEST_GUILESS_MAIN(TestSheet)
#include "test_sheet.moc"
