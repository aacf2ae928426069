// SPDX-License-Identifier: BSD-3-Clause
// Each decision of the plan: that it is taken, and that the picture stays the reference's.
#include "core/engine/plan.h"

#include <QTest>

#include "core/engine/fast_simulation.h"
#include "core/engine/plan_words.h"
#include "core/engine/view_rays.h"
#include "core/lens/lens_certificate.h"
#include "tests/core/rendered.h"
#include "tests/core/sample_view.h"

using namespace hogelscope;

namespace {

bool says(const View& view, const std::string& what) {
  const std::vector<Decision> decisions = decisionsOf(view, plan(view));
  return std::any_of(decisions.begin(), decisions.end(), [&](const Decision& decision) {
    return decision.what.find(what) != std::string::npos && !decision.why.empty();
  });
}

/// The largest difference from the reference, in code values.
int worstDifference(const View& view) {
  const Image fast = rendered(view);
  const Image reference = simulate(view);
  if (fast.seen != reference.seen) return 256;
  int worst = 0;
  for (std::size_t k = 0; k < fast.rgb.size(); ++k)
    worst = std::max(worst, std::abs(fast.rgb[k] - reference.rgb[k]));
  return worst;
}

}  // namespace

class TestPlan : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void saysInOneLineHowAViewRenders() {
    View view = sampleView();
    view.state.psf.windowSize = 1;
    QCOMPARE(oneLine(view, plan(view)), std::string("nearest, 1 ray a pixel, no leakage, no lens"));
    view.state.psf.windowSize = 7;
    view.state.psf.sigma = 0.2;  // the outermost taps change nothing
    view.sampling.samplesPerPixel = 2;
    view.sampling.reconstruction = Reconstruction::bilinear;
    view.state.distortion.k1 = 0.1;
    QCOMPARE(oneLine(view, plan(view)),
             std::string("bilinear, 4 rays a pixel, 9 of 49 taps, lens table kept"));
    view.state.camera.res = {9000, 9000};
    QVERIFY(oneLine(view, plan(view)).ends_with("lens row by row"));
  }

  void plainLensHasNoTable() {
    View view = sampleView();
    QVERIFY(!plan(view).hasLens && says(view, "no lens model"));
    LensTables tables;
    QVERIFY(ViewRays(view, tables, serialRows).lens() == nullptr);
    QCOMPARE(worstDifference(view), 0);
    view.state.distortion.k1 = 0.1;
    QVERIFY(plan(view).hasLens && plan(view).isTableKept);
    QCOMPARE(worstDifference(view), 0);
  }

  void statesWithOneLensShareItsTable() {
    View view = sampleView();
    view.state.distortion.k1 = 0.1;
    LensTables tables;
    const ViewRays first(view, tables, serialRows);
    view.state.camera.eye = {0.1, 0, 0.7};
    const ViewRays moved(view, tables, serialRows);
    QVERIFY(first.lens() != nullptr && first.lens() == moved.lens());
    view.state.camera.res = {71, 50};
    QVERIFY(ViewRays(view, tables, serialRows).lens() != first.lens());
  }

  void aTableThatIsTooLargeIsNotKept() {
    View view = sampleView();
    view.state.distortion.k1 = 0.1;
    view.state.camera.res = {16384, 16384};
    QVERIFY(!plan(view).isTableKept && says(view, "the lens"));
  }

  void windowOfOneHasNoPsf() {
    View view = sampleView();
    QCOMPARE(plan(view).psfReach, 0);
    QVERIFY(says(view, "no light leakage") && plan(view).copiesTexels);
  }

  void tapsThatDoNotCountAreLeftOut() {
    View view = sampleView();
    view.state.psf = {0.5, 9};
    QVERIFY(plan(view).psfReach < 4);
    QVERIFY(says(view, "taps, not 81"));
    QVERIFY(worstDifference(view) <= 1);
    view.state.psf = {0.67, 5};
    QCOMPARE(plan(view).psfReach, 2);
    QVERIFY(worstDifference(view) <= 1);
  }

  void linearLightOnlyWhereSomethingIsSummed() {
    View view = sampleView();
    view.state.psf.light = LightModel::linear;
    QVERIFY(!plan(view).sumsLinear && says(view, "no decoding"));
    QCOMPARE(worstDifference(view), 0);
    view.state.psf.windowSize = 3;
    QVERIFY(plan(view).sumsLinear);
    QVERIFY(worstDifference(view) <= 1);
  }

  void theOutlineIsKnownForPlainLenses() {
    View view = sampleView();
    QVERIFY(plan(view).knowsOutline);
    view.state.camera.fov = 80;
    const Image image = simulate(view);
    const auto seen = std::count(image.seen.begin(), image.seen.end(), std::uint8_t{255});
    LensTables tables;
    QCOMPARE(ViewRays(view, tables, serialRows).count(), std::int64_t(seen));
    QVERIFY(seen > 200 && seen < 3000);
    QCOMPARE(worstDifference(view), 0);
    view.display.lens = HogelLensModel::equiangular;
    QVERIFY(!plan(view).knowsOutline);
    QCOMPARE(worstDifference(view), 0);
  }

  void behindThePanelThereAreNoRays() {
    View view = sampleView();
    view.state.camera.eye.z = -1;
    QVERIFY(says(view, "no rays"));
    QCOMPARE(worstDifference(view), 0);
  }

  void theCertificateCountsWhatHasNoRay() {
    View view = sampleView();
    view.state.distortion = {0.2958943955272433, -1.0354662043042675};  // folds in the picture
    view.state.camera.fov = 90;
    const LensCertificate lens = certify(lensKeyOf(view.state, view.sampling), serialRows);
    QCOMPARE(lens.pixels, std::size_t(70 * 50));
    std::size_t without = 0;
    const Camera camera(view.state.camera);
    const Distortion distortion(view.state.distortion);
    for (int y = 0; y < 50; ++y)
      for (int x = 0; x < 70; ++x) without += distortion.undistort(camera.normalised(x, y)) ? 0 : 1;
    QCOMPARE(lens.withoutRay, without);
    QVERIFY(without > 100 && lens.worstResidual < 1e-9);
    QVERIFY(lens.reach > 0.6 && lens.reach < 0.7305);
    QVERIFY(std::abs(lens.validRadius - 0.7304) < 1e-4);
  }
};

QTEST_APPLESS_MAIN(TestPlan)
#include "test_plan.moc"
