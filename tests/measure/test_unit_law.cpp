// SPDX-License-Identifier: BSD-3-Clause
// Figures of units as built: simulated, they agree with the closed forms that know their errors;
// figures without such a form are left out and named.
#include <QTest>
#include <cmath>
#include <map>

#include "core/base/text.h"
#include "io/scene/view_source.h"
#include "measure/measure_run.h"

using namespace hogelscope;

namespace {

Session sessionOf(const TwinParams& twin) {
  Session session;
  session.display.size = {0.2, 0.15};
  session.display.hogels = {64, 48};
  session.display.directions = {24, 24};
  session.twin = twin;
  session.cameras.emplace_back();
  session.cameras[0].camera.name = "eye";
  session.cameras[0].camera.eye = {0.004, 0, 0.6};
  session.cameras[0].psf.light = LightModel::linear;
  return session;
}

/// Returns the unit's figures, of maps every 61st cell.
std::vector<MeasuredFigure> measured(const Session& session) {
  Bench bench = benchOf(session, displayOf(session), twinOf(session.twin, displayOf(session)));
  std::vector<Measurement> all = measurementsOf(session, bench);
  (void)keepThoseOfUnit(all, session.twin);
  std::vector<MeasuredFigure> result;
  int cell = 0;
  for (const Measurement& one : all) {
    const bool isOfMap = one.figure == "mtf" || one.where.starts_with("share");
    if (isOfMap && cell++ % 61 != 0) continue;
    result.push_back({one, one.simulate(bench), ""});
  }
  return result;
}

std::string leftOut(const TwinParams& twin) {
  const Session session = sessionOf(twin);
  const Bench bench = benchOf(session, displayOf(session), twinOf(twin, displayOf(session)));
  std::vector<Measurement> all = measurementsOf(session, bench);
  std::string lines;
  for (const std::string& line : keepThoseOfUnit(all, twin)) lines += line + "\n";
  return lines;
}

TwinParams unitOf(const std::string& error) {
  TwinParams twin;
  const bool isAll = error == "all of them";
  if (isAll || error == "offset") twin.lensArray.offset = {3e-4, -2e-4};
  if (isAll || error == "pitch") twin.lensArray.pitchError = {4e-3, -3e-3};
  if (isAll || error == "gap") twin.lensArray.gapError = 0.06;
  if (isAll || error == "focal length") twin.lensArray.focalError = -0.05;
  if (error == "rotation") twin.lensArray.rotation = 0.3;
  if (isAll || error == "colour") twin.colour.scale = {-0.01, 0.02, 0.015};
  if (isAll || error == "scatter") twin.random.shift.sigma = 4e-5;
  if (isAll || error == "black") twin.light.black = 0.05;
  if (isAll || error == "black") twin.light.ambient = {0.02, 0.02, 0.02};
  return twin;
}

}  // namespace

class TestUnitLaw : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void agreesWithClosedForms_data() {
    QTest::addColumn<std::string>("error");
    for (const char* error : {"offset", "pitch", "gap", "focal length", "rotation", "colour",
                              "scatter", "black", "all of them"})
      QTest::newRow(error) << std::string(error);
  }

  /// Absolute for ratios, relative for lengths and angles. Where a lens has its own direction, as
  /// with pitch and defocus, a zone is known to a lens, 1/64 of the panel.
  void agreesWithClosedForms() {
    QFETCH(std::string, error);
    const TwinParams twin = unitOf(error);
    const bool isScattered = twin.random.shift.sigma > 0;  // one draw of 64 hogels along the line
    const std::map<std::string, double> tolerances{{"hogelPitch", 1e-9},
                                                   {"slopeStep", 1e-9},
                                                   {"degreesPerDirection", 2e-3},
                                                   {"directionsPerPupil", 1e-9},
                                                   {"megapixels", 0},
                                                   {"viewingZone", 0.015},
                                                   {"spatialResolution", isScattered ? 0.05 : 0.01},
                                                   {"mtf", isScattered ? 0.03 : 0.01},
                                                   {"uniformity", 1e-6},
                                                   {"contrast", 1e-4},
                                                   {"depthOfField", isScattered ? 0.06 : 0.03},
                                                   {"depthOfField50", isScattered ? 0.06 : 0.03},
                                                   {"depthOfField10", isScattered ? 0.06 : 0.04},
                                                   {"parallaxStep", 1e-6},
                                                   {"throughFocus", isScattered ? 0.03 : 0.01}};
    std::map<std::string, int> compared;
    for (const MeasuredFigure& one : measured(sessionOf(twin))) {
      if (std::isinf(one.of.closedForm) && std::isinf(one.value)) continue;
      const double scale = one.of.unit.empty() ? 1 : std::max(std::abs(one.of.closedForm), 1e-9);
      const double difference = std::abs(one.difference()) / scale;
      const double most = tolerances.at(one.of.figure);
      ++compared[one.of.figure];
      QVERIFY2(difference <= most,
               qPrintable(QString::fromStdString(one.of.figure + " " + one.of.where + ": " +
                                                 numberText(one.value) + ", " +
                                                 numberText(one.of.closedForm))));
    }
    for (const char* figure : {"hogelPitch", "slopeStep", "mtf", "depthOfField", "parallaxStep"})
      QVERIFY2(compared[figure] > 0, figure);
    QCOMPARE(compared.count("viewingZone"), std::size_t(isScattered ? 0 : 1));
  }

  /// A unit without errors is the design.
  void aDesignStays() {
    const Session session = sessionOf({});
    Bench bench = benchOf(session, displayOf(session));
    QVERIFY(bench.twin() == nullptr);
    QCOMPARE(bench.law().scale[greenChannel], 1.0);
    QCOMPARE(bench.law().turn, 1.0);
  }

  void othersAreNamed() {
    TwinParams twin = unitOf("gap");
    QCOMPARE(leftOut(twin),
             std::string("since no formula is of a unit: qualifiedViewingSpace, "
                         "crosstalk, crosstalkMatrix, angularProfile, angularResolution, "
                         "depthFront, depthBehind, diffraction\n"));
    twin.light.falloff = 2;
    const std::string lines = leftOut(twin);
    QVERIFY2(lines.ends_with("since no formula knows twin.light.falloff: uniformity, "
                             "contrast, spatialResolution, mtf, depthOfField, depthOfField50, "
                             "depthOfField10, throughFocus\n"),
             lines.c_str());
    const auto changed = [](auto change) {
      TwinParams other;
      change(other);
      return other;
    };
    const auto why = [&](const char* figure, auto change) {
      return whyNotOfUnit(figure, changed(change));
    };
    QCOMPARE(why("mtf", [](TwinParams& t) { t.lensArray.wedge[0] = 0.01; }),
             std::string("no formula knows twin.lensArray.wedge"));
    QCOMPARE(why("slopeStep", [](TwinParams& t) { t.lensArray.wedge[0] = 0.01; }), std::string());
    QCOMPARE(why("hogelPitch", [](TwinParams& t) { t.maps.height = "h.exr"; }),
             std::string("no formula knows twin.maps.height"));
    QCOMPARE(why("viewingZone", [](TwinParams& t) { t.random.shift.sigma = 1e-6; }),
             std::string("no formula knows twin.random.shift"));
    QCOMPARE(why("uniformity", [](TwinParams& t) { t.random.gain.sigma = 0.1; }),
             std::string("no formula knows twin.random.gain"));
    QCOMPARE(why("contrast", [](TwinParams& t) { t.dead.rows = {1}; }),
             std::string("no formula knows twin.dead"));
  }
};

QTEST_APPLESS_MAIN(TestUnitLaw)
#include "test_unit_law.moc"
