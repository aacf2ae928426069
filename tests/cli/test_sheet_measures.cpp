// SPDX-License-Identifier: BSD-3-Clause
// Tests the figures of a lens sheet as a user meets them: --measure beside the formulas, written
// out again here, and the jobs that are for displays of hogels.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"

namespace {

constexpr double views = 40;
constexpr double slope = -5.6;
constexpr double distance = 0.6;
constexpr double eyeAt = 0.5;
constexpr double eyeHeight = 0.05;
constexpr double ipd = 0.063;

const double q = 0.0254 / 200;
const double p = 0.0254 / 40 / std::cos(std::atan(1 / slope));
const double tangent = std::tan(22.5 * M_PI / 180);
const double g = p / (2 * tangent);
const double width = 400 * q;
const double height = 240 * q;
constexpr double w = 0.4;

const QByteArray document = R"({"hogelscope": 1,
  "display": {"kind": "sheet", "viewingDistance": 0.6, "emitter": [0.4, 1], "position": [1, 2, 3],
    "calibration": {"pitch": 40, "slope": -5.6, "center": 0.3, "dpi": 200, "panel": [400, 240],
      "cone": 45}},
  "lightField": {"layout": "quilt", "file": "none_qs8x5a1.6.png"},
  "cameras": [{"name": "one", "eye": [1, 2.05, 3.5], "lookat": [1, 2, 3], "fov": 10}]})";

double sinc(double x) {
  return x == 0 ? 1 : std::sin(M_PI * x) / (M_PI * x);
}

double depthOf(double spread, double sign) {
  return p * eyeAt / (spread * eyeAt + sign * p);
}

/// A figure's closed form; NaN for those whose forms the tests of core and measure have.
double lawOf(const QString& figure, const QString& unit, const QString& where) {
  const double viewSlope = p / (views * g);
  if (figure == "viewsPerMetre")
    return (where.contains("panel") ? eyeAt * (1 / distance - 1 / eyeAt) : 1) / (viewSlope * eyeAt);
  if (figure == "viewingCone") return unit == "m" ? 2 * eyeAt * tangent : 45;
  if (figure == "flip")
    return (where.startsWith("left") ? -1 : 1) * eyeAt * tangent - eyeHeight / slope;
  if (figure == "pseudoscopic") return ipd / (2 * eyeAt * tangent);
  if (figure == "lobe") return views * q / p * std::sqrt((w * w + 1 / (slope * slope)) / 12);
  if (figure == "viewsFront") return depthOf(viewSlope, 1);
  if (figure == "viewsBehind") return depthOf(viewSlope, -1);
  if (figure == "viewingZone" && unit == "m")
    return 2 * eyeAt * tangent - (width - height / slope) * (1 - eyeAt / distance);
  if (figure == "mtf") {
    const double f = 1000 * where.section('=', 1, 1).section('/', 0, 0).toDouble();
    const double z = where.section("z=", 1, 1).section(' ', 0, 0).toDouble();
    const double square = 1 + 1 / (slope * slope);
    return std::abs(sinc(f * p * ((1 - z / distance) / square + z / distance)) *
                    sinc(f * q * (1 - z / distance - w * z / g)) * sinc(f * q * z / (slope * g)) *
                    sinc(f * z * viewSlope));
  }
  return std::nan("");
}

/// How far what is simulated may be from it: flips and depths lie between views.
double allowed(const QString& figure, double law) {
  if (figure == "mtf") return 0.02;
  if (figure == "viewsPerMetre") return 1;  // 1/60 view from one end of the panel to the other
  if (figure == "flip") return 1e-3;
  return 0.02 * std::abs(law);
}

}  // namespace

class TestSheetMeasures : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void figures();
  void sharpIsOneDepth();
  void refusals_data();
  void refusals();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSheetMeasures::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeFile("s.json", document);
}

/// Neither the quilt nor the sheet that it is woven for, nor the display's place makes a
/// difference.
void TestSheetMeasures::figures() {
  writeFile("unit.json", R"({"hogelscope": 1, "twin": {"lensArray": {"gapError": 0.04}}})");
  const Outcome outcome = run({"--measure", "--session", "s.json", "--output", "out", "--twin",
                               "unit.json", "--set", "lightField.calibration.center=0.8"},
                              m_folder->path());
  // The figures below are those of the design.
  const QByteArray unit =
      "hogelscope: s.json: warning: a lens sheet is measured as designed, without its twin\n";
  QVERIFY2(outcome.err.startsWith(unit), outcome.err);
  compareLine(outcome.err.mid(unit.size()).chopped(1),
              "hogelscope: s.json: warning: the panel is woven for the lens sheet itself, not for "
              "lightField.calibration");
  QCOMPARE(outcome.status, 0);
  QVERIFY2(outcome.out.contains("  viewsPerMetre (to the eye's right z=0.5 m): "), outcome.out);
  QList<QStringList> rows = tableOf("out/measure.csv");
  QCOMPARE(rows.takeFirst().join(","), QString("figure,value,unit,where,closed_form,difference"));
  QMap<QString, int> counts;
  for (const QStringList& row : rows) {
    QCOMPARE(row.size(), 6);
    ++counts[row[0]];
    const double value = row[1].toDouble();
    const double form = row[4].toDouble();
    const QByteArray line = row.join(" ").toUtf8();
    if (const double law = lawOf(row[0], row[2], row[3]); !std::isnan(law)) {
      QVERIFY2(std::abs(form - law) <= (row[0] == "mtf" ? 2e-3 : 1e-9), line);
      QVERIFY2(std::abs(value - law) <= allowed(row[0], law), line);
    }
    if (row[0] == "spatialResolution" || row[0].startsWith("depth") || row[3].startsWith("full"))
      QVERIFY2(std::abs(value - form) <= 0.03 * form, line);
    // As shares of all light, which do not grow without limit.
    const auto share = [](double ratio) { return ratio / (1 + ratio); };
    if ((row[0] == "crosstalk" || row[0] == "angularProfile") && !row[4].isEmpty())
      QVERIFY2(std::abs(share(value) - share(form)) < 0.04, line);
    if (row[0] == "throughFocus") QVERIFY2(std::abs(value - form) < 0.03, line);
  }
  QCOMPARE(counts["mtf"], 41 * 24);
  QCOMPARE(counts["viewingZone"], 1 + 41 * 25);
  QCOMPARE(counts["crosstalk"], 19);
  QCOMPARE(counts["spatialResolution"], 5);
  // Figures of hogels alone are left out.
  QCOMPARE(counts.keys().join(" "),
           QString("angularProfile crosstalk depthBehind depthFront depthOfField depthOfField10 "
                   "depthOfField50 flip lobe mtf pseudoscopic spatialResolution throughFocus "
                   "viewingCone viewingZone viewsBehind viewsFront viewsPerMetre"));
  QCOMPARE(namesIn("out/plots").filter(".csv"),
           (QStringList{"angular_profile.csv", "crosstalk.csv", "mtf.csv", "through_focus.csv",
                        "viewing_zone.csv"}));
  const QByteArray page = contentOf("out/measure.html");
  QVERIFY(page.contains("40 views under a lens sheet of"));
  QVERIFY(!page.contains("hogel"));
}

/// What --info says to be sharp is the closed form of --measure, for the same views and the same
/// eye.
void TestSheetMeasures::sharpIsOneDepth() {
  const QByteArray calibration =
      R"({"pitch": {"value": 50.0}, "slope": {"value": -6}, "center": {"value": 0.3},
          "DPI": {"value": 283}, "screenW": {"value": 2560}, "screenH": {"value": 1600},
          "viewCone": {"value": 45}})";
  writeFile("visual.json", calibration);
  const Outcome info = run({"--info", "visual.json"}, m_folder->path());
  QCOMPARE(info.status, 0);
  writeFile("u.json", R"({"hogelscope": 1,
    "display": {"kind": "sheet", "calibration": "visual.json"},
    "lightField": {"layout": "quilt", "file": "none_qs8x6a1.6.png"},
    "cameras": [{"name": "one", "eye": [0, 0, 0.6]}]})");
  QCOMPARE(run({"--measure", "--session", "u.json", "--output", "u"}, m_folder->path()).status, 0);
  QStringList depths;
  for (const QStringList& row : tableOf("u/measure.csv")) {
    if (row[0] != "depthFront" && row[0] != "depthBehind") continue;
    depths << QString::number(1000 * row[4].toDouble(), 'f', 1);
  }
  QCOMPARE(depths.size(), 2);
  const QString line =
      QString("with 48 views %1 mm in front and %2 mm behind").arg(depths[0], depths[1]);
  QVERIFY2(info.out.contains(line.toUtf8()), qPrintable(line + info.out));
}

void TestSheetMeasures::refusals_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("line");
  const auto row = [](const QStringList& arguments, const QByteArray& line) {
    QTest::newRow(arguments.join(" ").toUtf8()) << arguments << line;
  };
  row({"--measure", "--set", "lightField.file=quilt.png"},
      "s.json: lightField.columns: and rows are missing: what a lens sheet shows depends on its "
      "number of views");
  row({"--depth"}, "s.json: display.kind: is \"sheet\", which a depth budget does not know");
  row({"--tradeoff"}, "s.json: display.kind: is \"sheet\", which a trade-off does not know");
  row({"--sweep", "t.json"}, "s.json: display.kind: is \"sheet\", which a sweep does not know");
}

void TestSheetMeasures::refusals() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, line);
  writeFile("t.json", R"({"parameters": {"camera.fov": [20, 30]}, "figures": ["mtf:0"]})");
  const Outcome outcome =
      run(arguments + QStringList{"--session", "s.json", "--output", "out"}, m_folder->path());
  QCOMPARE(outcome.status, 2);
  compareLine(outcome.err.chopped(1), "hogelscope: " + line);
  QVERIFY(!QFileInfo::exists("out"));
}

QTEST_GUILESS_MAIN(TestSheetMeasures)
#include "test_sheet_measures.moc"
