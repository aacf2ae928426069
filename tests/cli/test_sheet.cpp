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
  void wrongCalibration();
  void wovenPictures();
  void liveScenes();
  void spots();
  void invertedViews();
  void flippedSubPixels();
  void everyJobSaysWhatIsIgnored();
  void unitsAgainstTheDesign();
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

/// A panel that is woven for another center than that of the lenses: a share of the period aside,
/// each eye sees as large a share of the views aside.
void TestSheet::wrongCalibration() {
  const auto viewSeen = [&](const QString& set) {
    const Outcome outcome = program({"--render", "--session", "s.json", "--output", "out",
                                     "--states", "2", "--set", set, "--save-session", "kept.json"});
    if (outcome.status != 0) qFatal("%s", outcome.err.constData());
    const QRgb colour = QImage("out/2.png").pixel(40, 30);
    return qRed(colour) / 40;
  };
  QCOMPARE(viewSeen("lightField.calibration.center=0.1"), 2);
  // One view of six; a smaller center is a larger phase, and that is a view on the left.
  QCOMPARE(viewSeen("lightField.calibration.center=" + QString::number(0.1 + 1.0 / views)), 3);
  QCOMPARE(viewSeen("lightField.calibration.center=" + QString::number(0.1 - 2.0 / views)), 0);
  // The session keeps the panel's own figures, and the display's are its document's.
  const QByteArray kept = contentOf("kept.json");
  QVERIFY(kept.contains("\"calibration\": \"visual.json\""));
  QVERIFY(kept.contains("\"pitch\": 5.0"));
  QCOMPARE(
      program({"--render", "--session", "kept.json", "--output", "again", "--states", "2"}).status,
      0);
  QCOMPARE(contentOf("again/2.png"), contentOf("out/2.png"));
  // A document of its own.
  QVERIFY(QDir().mkpath("sub"));
  writeFile("other.json", QByteArray(calibration).replace("0.1", "0.26666667"));
  writeFile("s.json", session().replace(R"("lightField": {)",
                                        R"("lightField": {"calibration": "other.json", )"));
  QCOMPARE(program({"--render", "--session", "s.json", "--output", "out", "--states", "2",
                    "--save-session", "sub/own.json"})
               .status,
           0);
  QCOMPARE(qRed(QImage("out/2.png").pixel(40, 30)), 120);
  QVERIFY(contentOf("sub/own.json").contains("\"calibration\": \"../other.json\""));
}

/// The picture that --export woven writes is content, too: it is seen as the quilt is.
void TestSheet::wovenPictures() {
  QCOMPARE(program({"--export", "woven", "--session", "s.json", "--output", "panel.png"}).status,
           0);
  QCOMPARE(program({"--render", "--session", "s.json", "--output", "a"}).status, 0);
  writeFile("w.json", session(R"("calibration": "visual.json")", "", "woven")
                          .replace("q_qs6x1a1.5.png", "panel.png"));
  QCOMPARE(program({"--render", "--session", "w.json", "--output", "b"}).err, QByteArray());
  for (int k = 0; k < views; ++k)
    QCOMPARE(contentOf(QString("b/%1.png").arg(k)), contentOf(QString("a/%1.png").arg(k)));
  QCOMPARE(program({"--export", "woven", "--session", "w.json", "--output", "c.png"}).status, 0);
  QVERIFY(QImage("c.png") == QImage("panel.png"));
}

/// From the middle of a view an eye sees what it would see of the scene itself, but for the
/// panel's pixels.
void TestSheet::liveScenes() {
  const QByteArray live =
      QByteArray(R"({"hogelscope": 1, "display": {"kind": "sheet", "calibration": {"pitch": 30,
        "slope": -6, "center": 0.1, "cone": 40, "dpi": 200, "panel": [960, 640]},
        "hogels": [320, 213], "directions": [24, 1]},
      "lightField": {"layout": "live", "source": "scene", "scene": {"fill": [0.5, 0.5]}},
      "cameras": [)") +
      R"({"name": "left", "eye": [-0.163789, 0, 0.6], "fov": 10, "res": [200, 150]},
         {"name": "right", "eye": [0.163789, 0, 0.6], "fov": 10, "res": [200, 150]}]})";
  writeFile("live.json", live);
  QCOMPARE(program({"--render", "--session", "live.json", "--output", "a"}).err, QByteArray());
  QCOMPARE(program({"--render", "--session", "live.json", "--output", "b", "--ideal"}).err,
           QByteArray());
  const auto differenceOf = [](const QString& one, const QString& other) {
    const QImage a(one);
    const QImage b(other);
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x)
        sum += std::abs(qGreen(a.pixel(x, y)) - qGreen(b.pixel(x, y)));
    return sum / (a.width() * a.height());
  };
  const double own = differenceOf("a/left.png", "b/left.png");
  const double other = differenceOf("a/right.png", "b/right.png");
  const double crossed = differenceOf("a/left.png", "b/right.png");
  const QByteArray all = QByteArray::number(own) + ", " + QByteArray::number(other) + ", crossed " +
                         QByteArray::number(crossed);
  QVERIFY2(own < 16 && other < 16, all);
  QVERIFY2(crossed > 2 * std::max(own, other), all);
  // Its quilt has the sheet's views: seen on the sheet it is the scene.
  const Outcome exported =
      program({"--export", "quilt", "--session", "live.json", "--output", "scene_qs6x4a1.5.png"});
  QCOMPARE(exported.err, QByteArray());
  QCOMPARE(exported.out, QByteArray("scene_qs6x4a1.5.png: quilt, lightField.columns=6 "
                                    "lightField.rows=4\n"));
  QCOMPARE(QImage("scene_qs6x4a1.5.png").size(), QSize(6 * 320, 4 * 213));
  writeFile(
      "quilt.json",
      QByteArray(live)
          .replace(R"("hogels": [320, 213], "directions": [24, 1])", R"("viewingDistance": 0.6)")
          .replace(R"("layout": "live", "source": "scene", "scene": {"fill": [0.5, 0.5]})",
                   R"("layout": "quilt", "file": "scene_qs6x4a1.5.png")"));
  QCOMPARE(program({"--render", "--session", "quilt.json", "--output", "c"}).err, QByteArray());
  for (const char* const name : {"left.png", "right.png"})
    QVERIFY(QImage(QString("c/") + name) == QImage(QString("a/") + name));
  QCOMPARE(program({"--export", "views", "--session", "live.json", "--output", "views"}).err,
           QByteArray());
  QCOMPARE(namesIn("views").size(), 24);
  QCOMPARE(QImage("views/000_007.png"),  // the second tile from the bottom and from the left
           QImage("scene_qs6x4a1.5.png").copy(320, 2 * 213, 320, 213));
}

/// With a spot as wide as the lenses' period an eye sees the mean of all views.
void TestSheet::spots() {
  QCOMPARE(program({"--render", "--session", "s.json", "--output", "out", "--set",
                    "display.spot=0.001", "--set", "psf.light=linear"})
               .err,
           QByteArray());
  QCOMPARE(
      program({"--render", "--session", "s.json", "--output", "none", "--set", "display.spot=0"})
          .err,
      QByteArray());
  const int second = qGreen(QImage("out/1.png").pixel(40, 30));
  const int last = qGreen(QImage("out/5.png").pixel(40, 30));
  QCOMPARE(qGreen(QImage("none/1.png").pixel(40, 30)), 40);
  QVERIFY2(second > 60 && second < 140, QByteArray::number(second));
  QVERIFY2(last < 180, QByteArray::number(last));
}

/// invView 0 is ignored, with a warning that a saved session keeps.
void TestSheet::invertedViews() {
  const QStringList render{"--render", "--session", "s.json", "--output", "a", "--states", "2"};
  QCOMPARE(program(render).err, QByteArray());
  const QByteArray right = contentOf("a/2.png");
  writeFile("visual.json",
            QByteArray(calibration).replace("\"slope\"", "\"invView\": 0, \"slope\""));
  const QByteArray warning =
      ": warning: display.calibration: invView is 0, which is ignored: views go from left to "
      "right\n";
  QCOMPARE(program(render + QStringList{"--set", "display.calibration.cone=40", "--save-session",
                                        "kept.json"})
               .err,
           "hogelscope: s.json" + warning);
  QCOMPARE(contentOf("a/2.png"), right);
  QCOMPARE(program({"--render", "--session", "kept.json", "--output", "b", "--states", "2"}).err,
           "hogelscope: kept.json" + warning);
}

/// Red and blue sub-pixels that stand exchanged need each other's views: of grey views the panel's
/// red is the other panel's blue, and an eye sees them exchanged, too.
void TestSheet::flippedSubPixels() {
  const QByteArray fine = QByteArray(calibration).replace("5.0", "17.3");
  for (const int flip : {0, 1}) {
    const QString k = QString::number(flip);
    writeFile("visual" + k + ".json",
              QByteArray(fine).replace("\"slope\"", "\"flipSubp\": " + k.toUtf8() + ", \"slope\""));
    writeFile("s" + k + ".json", session("\"calibration\": \"visual" + k.toUtf8() + ".json\""));
    QCOMPARE(program({"--export", "woven", "--session", "s" + k + ".json", "--output",
                      "panel" + k + ".png"})
                 .err,
             QByteArray());
    QCOMPARE(program({"--render", "--session", "s" + k + ".json", "--output", "seen" + k}).err,
             QByteArray());
  }
  QVERIFY(program({"--info", "visual1.json"}).out.contains("stripes of blue, green, red"));
  const auto isExchanged = [](const QString& a, const QString& b, int least) {
    const QImage one(a), other(b);
    int different = 0;
    for (int y = 0; y < one.height(); ++y)
      for (int x = 0; x < one.width(); ++x) {
        const QRgb p = one.pixel(x, y), q = other.pixel(x, y);
        if (qRed(p) != qBlue(q) || qGreen(p) != qGreen(q) || qBlue(p) != qRed(q)) return false;
        different += p != q ? 1 : 0;
      }
    return different > least;
  };
  QVERIFY(isExchanged("panel0.png", "panel1.png", 1000));
  QVERIFY(isExchanged("seen0/2.png", "seen1/2.png", 0));
}

void TestSheet::everyJobSaysWhatIsIgnored() {
  writeFile(
      "visual.json",
      QByteArray(calibration).replace("\"slope\"", "\"invView\": 0, \"fringe\": 2, \"slope\""));
  const QByteArray begin = "hogelscope: s.json: warning: display.calibration: ";
  const QByteArray lines = begin + "fringe is 2, which is not used\n" + begin +
                           "invView is 0, which is ignored: views go from left to right\n";
  for (const QStringList& job : {QStringList{"--export", "woven", "--output", "panel.png"},
                                 {"--render", "--output", "a"},
                                 {"--measure", "--output", "m"}}) {
    const Outcome outcome = program(job + QStringList{"--session", "s.json"});
    QVERIFY2(outcome.err.startsWith(lines), job[0].toUtf8() + outcome.err);
  }
  const QByteArray info = program({"--info", "s.json"}).out;
  QVERIFY2(info.contains("warning     display.calibration: invView is 0"), info);
}

/// A sheet that is mounted a sixth of a period aside shows the next view.
void TestSheet::unitsAgainstTheDesign() {
  const double period = 0.0254 / 5 / std::cos(std::atan(1.0 / 6));
  const double gap = period / (2 * tangent);
  const double lens = period / (1 + gap / distance);
  writeFile("unit.json",
            R"({"lensArray": {"offset": [)" + QByteArray::number(lens / views, 'g', 9) + ", 0]}}");
  QCOMPARE(program({"--render", "--session", "s.json", "--twin", "unit.json", "--output", "out",
                    "--states", "2"})
               .err,
           QByteArray());
  QCOMPARE(qRed(QImage("out/2.png").pixel(40, 30)), 40);
  QCOMPARE(program({"--report", "--session", "s.json", "--twin", "unit.json", "--against", "design",
                    "--output", "report", "--quiet"})
               .status,
           0);
  const auto table = tableOf("report/report.csv");
  QCOMPARE(table.size(), views + 1);
  QVERIFY(table[1][table[0].indexOf("mse")].toDouble() > 100);
  // Five of six rays meet pixels d aside, a sixth of the lenses' images; one meets the next lens,
  // and pixels 5 d to the other side: √5 d, and the rows to which rays slide.
  const auto metrics = tableOf("report/metrics.csv");
  const double moved = metrics[1][metrics[0].indexOf("move_rms")].toDouble();
  const double pixels = std::sqrt(5) * period / views / (0.0254 / 50);
  QVERIFY2(moved > pixels && moved < pixels + 0.6,
           QByteArray::number(moved) + ", about " + QByteArray::number(pixels));
  // The unit itself is not mended by moving the sheet by a whole period.
  writeFile("unit.json",
            R"({"lensArray": {"offset": [)" + QByteArray::number(lens, 'g', 12) + ", 0]}}");
  QCOMPARE(program({"--render", "--session", "s.json", "--twin", "unit.json", "--output", "out",
                    "--states", "2"})
               .status,
           0);
  QCOMPARE(qRed(QImage("out/2.png").pixel(40, 30)), 80);
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
      "s.json: lightField.layout: must be \"quilt\", \"woven\" or \"live\" for a lens sheet");
  row(render, session(own, "", "woven"),
      "q_qs6x1a1.5.png: size: is 180×20 px, but the lens sheet's panel has 180×120");
  row(render + QStringList{"--set", "lightField.calibration.panel=[100,100]"}, session(),
      "s.json: lightField.calibration.panel: is not the display's, 180×120 px");
  row(render + QStringList{"--set", "lightField.calibration.slope=0"}, session(),
      "s.json: lightField.calibration.slope: is 0: …");
  row(render + QStringList{"--set", "lightField.calibration.center=0"}, session(own, "", "woven"),
      "s.json: lightField.calibration: is for views: the panel's picture is woven already");
  row(render,
      session()
          .replace(R"("display": {"kind": "sheet", "calibration": "visual.json"}, )", "")
          .replace("{\"file\"", "{\"calibration\": \"visual.json\", \"file\""),
      "s.json: lightField.calibration: is for a lens sheet: a display of kind \"sheet\"");
  row(render,
      session()
          .replace(R"("display": {"kind": "sheet", "calibration": "visual.json"}, )", "")
          .replace("\"quilt\"", "\"woven\""),
      "s.json: lightField.layout: is \"woven\", …");
  row(render, session(own + R"(, "hogels": [30, 20], "directions": [6, 1])"),
      "s.json: display.hogels: is of a live scene's views: for a lens sheet the file says it");
  row(render,
      session(own + R"(, "hogels": [30, 20], "directions": [6, 2])")
          .replace(R"("file": "q_qs6x1a1.5.png", "layout": "quilt")",
                   R"("layout": "live", "source": "scene")"),
      "s.json: display.directions: must be one row of views for a lens sheet: [6, 1]");
  row(render,
      session(own).replace(R"("file": "q_qs6x1a1.5.png", "layout": "quilt")",
                           R"("layout": "live", "source": "scene")"),
      "s.json: display.hogels: is missing: a scene does not say it");
  row(render, session(own, R"("twin": {"light": {"bits": 6}}, )"),
      "s.json: twin: has errors that a lens sheet cannot have: …");
  row(render, session(own, R"("sampling": {"reconstruction": "bilinear"}, )"),
      "s.json: sampling.reconstruction: must be \"nearest\" for a lens sheet, whose pixels are not "
      "interpolated");
  row(render + QStringList{"--set", "psf.windowSize=3"}, session(),
      "s.json: cameras[0].psf.windowSize: must be 1 for a lens sheet, whose pixels have no "
      "directions to leak into");
  row({"--export", "pack", "--session", "s.json", "--output", "out.tif"}, session(),
      "s.json: display.kind: is \"sheet\", which a pack does not know");
  row(render + QStringList{"--save-session", "visual.json"}, session(),
      "visual.json: cannot be written: it is visual.json, which is read: choose another name");
  row({"--export", "hogels", "--session", "s.json", "--output", "out"}, session(),
      "--export hogels: is for a display of hogels: give quilt, views or woven for a lens sheet");
  row({"--export", "quilt", "--session", "s.json", "--output", "out"},
      session(R"("calibration": "visual.json")", "", "woven"),
      "s.json: lightField.layout: is \"woven\", a picture of the panel, which does not say its "
      "views");
  row({"--export", "quilt", "--session", "s.json", "--output", "out", "--for-twin"}, session(),
      "command line: --for-twin: is not for the views of a lens sheet");
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
