// SPDX-License-Identifier: BSD-3-Clause
// All figures of displays: those with a closed form agree with it; those without are worked out
// here by other means.
#include <QTest>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "measure/measure_run.h"

using namespace hogelscope;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double distance = 0.6;

Session sessionOf(const PanelParams& display) {
  Session session;
  session.display = display;
  session.cameras.emplace_back();
  session.cameras[0].camera.name = "eye";
  session.cameras[0].camera.eye = {0.004, 0, distance};
  return session;
}

PanelParams displayOf(int hogels, int directions) {
  PanelParams display;
  display.size = {0.2, 0.15};
  display.hogels = {hogels, 3 * hogels / 4};
  display.directions = {directions, directions};
  return display;
}

/// Measures the figures of these names, all without any; of maps every 31st cell.
std::vector<MeasuredFigure> measured(const Session& session, const PanelParams& display,
                                     const std::vector<std::string>& names) {
  Bench bench = benchOf(session, display);
  std::vector<MeasuredFigure> result;
  int cell = 0;
  for (const Measurement& one : measurementsOf(session, bench)) {
    if (!names.empty() && std::ranges::find(names, one.figure) == names.end()) continue;
    if (one.figure == "mtf" && cell++ % 31 != 0) continue;
    result.push_back({one, one.simulate ? one.simulate(bench) : NAN, ""});
  }
  return result;
}

const MeasuredFigure& named(const std::vector<MeasuredFigure>& figures, const std::string& where) {
  return *std::ranges::find_if(
      figures, [&](const MeasuredFigure& one) { return one.of.where.starts_with(where); });
}

}  // namespace

class TestMeasurements : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void agreeWithClosedForms_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("plain") << 0;
    QTest::newRow("leakage, encoded") << 1;
    QTest::newRow("leakage, linear, clamped") << 2;
    QTest::newRow("converging, odd number") << 3;
    QTest::newRow("horizontal parallax") << 4;
    QTest::newRow("vertical parallax") << 5;
    QTest::newRow("pupil") << 6;
  }

  void agreeWithClosedForms() {
    QFETCH(int, kind);
    PanelParams display = displayOf(64, kind == 3 ? 25 : 24);
    if (kind == 3) display.viewingDistance = 0.7;
    if (kind == 4) display.directions[1] = 1;
    if (kind == 5) display.directions[0] = 1;
    Session session = sessionOf(display);
    PsfParams& psf = session.cameras[0].psf;
    if (kind == 1 || kind == 2) psf.windowSize = 5;
    if (kind == 2) psf.light = LightModel::linear;
    if (kind == 2) psf.border = PsfBorder::clamp;
    if (kind == 6) {
      session.cameras[0].pupil.diameter = 0.004;
      session.cameras[0].pupil.samples = 60;
    }
    // Absolute for ratios, relative for lengths and angles.
    const std::map<std::string, double> tolerances{{"hogelPitch", 1e-9},
                                                   {"slopeStep", 1e-9},
                                                   {"degreesPerDirection", 1e-9},
                                                   {"directionsPerPupil", 1e-9},
                                                   {"megapixels", 0},
                                                   {"viewingZone", 3e-3},
                                                   {"crosstalk", 1e-6},
                                                   {"crosstalkMatrix", 1e-6},
                                                   {"angularProfile", 1e-6},
                                                   {"angularResolution", 1e-3},
                                                   {"spatialResolution", 0.01},
                                                   {"mtf", 0.01},
                                                   {"uniformity", 1e-9},
                                                   {"contrast", 0},
                                                   {"depthOfField", 0.02},
                                                   {"depthOfField50", 0.03},
                                                   {"depthOfField10", 0.03},
                                                   {"depthFront", 0.02},
                                                   {"depthBehind", 0.02},
                                                   {"parallaxStep", 1e-6},
                                                   {"throughFocus", 0.01}};
    std::map<std::string, int> compared;
    for (const MeasuredFigure& one : measured(session, display, {})) {
      if (std::isnan(one.of.closedForm) || one.of.figure == "diffraction") continue;
      const double scale = one.of.unit.empty() ? 1 : std::abs(one.of.closedForm);
      const bool isNear = std::abs(one.difference()) <= tolerances.at(one.of.figure) * scale;
      QVERIFY2(isNear,
               qPrintable(QString::fromStdString(one.of.figure + " " + one.of.where) + " " +
                          QString::number(one.value) + " " + QString::number(one.of.closedForm)));
      ++compared[one.of.figure];
    }
    QVERIFY(compared["mtf"] > 25);
    QVERIFY(compared["viewingZone"] > 1000);
    if (kind < 3) QCOMPARE(compared.size(), tolerances.size());
  }

  /// The list of figures has all that are measured, with the unit of a measurement, and no others.
  void areListed() {
    PanelParams sheet;
    sheet.sheet.emplace();
    sheet.sheet->calibration.params = {5, -6, 0.1, 50, {180, 120}, 40};
    sheet.size = LensSheet(*sheet.sheet).size();
    sheet.hogels = sheet.sheet->calibration.params.panel;
    sheet.directions = {12, 1};
    std::set<std::string> valued;
    for (const PanelParams& display : {displayOf(64, 24), sheet}) {
      const Bench bench = benchOf(sessionOf(display), display);
      for (const Measurement& one : measurementsOf(sessionOf(display), bench)) {
        QVERIFY2(figureRow(one.figure).name == one.figure, one.figure.c_str());
        if (figureRow(one.figure).isOf(one)) valued.insert(one.figure);
      }
    }
    for (const FigureRow& row : figureRows())
      if (row.sweptWith == SweptWith::nothing || row.sweptWith == SweptWith::bench)
        QVERIFY2(valued.contains(std::string(row.name)), std::string(row.name).c_str());
  }

  /// Crosstalk and angles are measured through 1° at most; contrast through the eye's own pupil.
  void limitsTheAperture() {
    const PanelParams display = displayOf(64, 96);
    const auto through = [&](double degrees) {
      Session session = sessionOf(display);
      session.cameras[0].pupil.diameter = 2 * distance * std::tan(degrees * pi / 360);
      session.cameras[0].pupil.samples = 60;
      return measured(session, display, {"crosstalk", "angularProfile", "throughFocus"});
    };
    const auto narrow = through(0.4);
    const auto limit = through(1);
    const auto wide = through(2);
    QVERIFY(limit.size() > 20);
    int narrower = 0;
    for (std::size_t k = 0; k < wide.size(); ++k) {
      if (wide[k].of.figure == "throughFocus") continue;
      QVERIFY(std::abs(wide[k].value - limit[k].value) < 1e-12 || std::isnan(wide[k].value));
      narrower += std::abs(narrow[k].value - limit[k].value) > 1e-3;
    }
    QVERIFY(narrower > 5);
  }

  /// The qualified viewing space of a display without leakage is where 95 % of the panel is seen.
  void qualifiedSpace() {
    const PanelParams display = displayOf(64, 24);
    const auto figures = measured(sessionOf(display), display, {"qualifiedViewingSpace"});
    // 0.95 of the width is seen: |x| ≤ D tan(F/2) − W/2 + 0.05 W.
    const double half = distance * std::tan(pi / 6) - 0.1 + 0.05 * 0.2;
    QVERIFY2(std::abs(named(figures, "across").value - 2 * half) < 2e-3,
             qPrintable(QString::number(named(figures, "across").value)));
    QVERIFY(named(figures, "from z").value < distance);
    QVERIFY(named(figures, "to z").value > distance);
    // With much leakage the eyes see each other's pictures everywhere.
    Session leaking = sessionOf(display);
    leaking.cameras[0].psf = {3, 13, PsfBorder::renormalise, LightModel::linear};
    QCOMPARE(named(measured(leaking, display, {"qualifiedViewingSpace"}), "across").value, 0.0);
  }

  /// Light that leaks over the panel's edge directions is lost where the border is black.
  void unevenField() {
    const PanelParams display = displayOf(64, 24);
    Session session = sessionOf(display);
    session.cameras[0].psf = {4, 21, PsfBorder::black, LightModel::linear};
    const auto figures = measured(session, display, {"uniformity"});
    for (const MeasuredFigure& one : figures) QVERIFY(std::isnan(one.of.closedForm));
    QVERIFY(named(figures, "least/most of 9 eyes").value < 0.95);
    QVERIFY(named(figures, "least/most of 9 eyes").value > 0.3);
  }

  void unlimitedDepth() {
    const PanelParams display = displayOf(20, 200);  // s D < p
    const auto figures = measured(sessionOf(display), display, {"depthBehind"});
    QVERIFY(std::isinf(figures[0].value) && figures[0].value > 0);
    QCOMPARE(figures[0].difference(), 0.0);
  }

  void csvCells() {
    Measurement one{"mtf", "", "f=0.4/mm z=0.02 m", {}, 0.5};
    QCOMPARE(QString::fromStdString(csv({{one, 0.25, ""}, {one, NAN, ""}})),
             QString("figure,value,unit,where,closed_form,difference\n"
                     "mtf,0.25,,f=0.4/mm z=0.02 m,0.5,-0.25\n"
                     "mtf,,,f=0.4/mm z=0.02 m,0.5,\n"));
  }
};

QTEST_GUILESS_MAIN(TestMeasurements)
#include "test_measurements.moc"
