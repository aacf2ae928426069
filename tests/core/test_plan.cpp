// SPDX-License-Identifier: BSD-3-Clause
// Each decision of the plan: that it is taken, and that the image stays the reference's.
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

bool says(const RenderJob& job, const std::string& what) {
  const std::vector<Decision> decisions = decisionsOf(job, plan(job));
  return std::any_of(decisions.begin(), decisions.end(), [&](const Decision& decision) {
    return decision.what.find(what) != std::string::npos && !decision.why.empty();
  });
}

/// The largest difference from the reference, in code values.
int worstDifference(const RenderJob& job) {
  const Image fast = rendered(job);
  const Image reference = simulate(job);
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
    RenderJob job = sampleView();
    job.state.psf.windowSize = 1;
    QCOMPARE(oneLine(job, plan(job)), std::string("nearest, 1 ray a pixel, no leakage, no lens"));
    job.state.psf.windowSize = 7;
    job.state.psf.sigma = 0.2;  // the outermost taps change nothing
    job.sampling.samplesPerPixel = 2;
    job.sampling.reconstruction = Reconstruction::bilinear;
    job.state.distortion.k1 = 0.1;
    QCOMPARE(oneLine(job, plan(job)),
             std::string("bilinear, 4 rays a pixel, 9 of 49 taps, lens table kept"));
    job.state.camera.res = {9000, 9000};
    QVERIFY(oneLine(job, plan(job)).ends_with("lens row by row"));
  }

  void pupilsAreSampledWhereTheyMatter() {
    RenderJob job = sampleView();
    job.state.pupil.diameter = 1e-6;
    QVERIFY(plan(job).aperture.isPinhole && says(job, "a pinhole"));
    QVERIFY(plan(job).copiesTexels);
    job.state.pupil = {0.02, 0, 7};
    QVERIFY(says(job, "7 samples of the pupil") && !plan(job).copiesTexels);
    QVERIFY(oneLine(job, plan(job)).find("7 samples of the pupil, ") != std::string::npos);
    QVERIFY(worstDifference(job) <= 1);
    job.state.pupil.samples = 0;
    const std::string wanted = std::to_string(plan(job).aperture.wanted);
    QVERIFY(says(job, wanted + " samples of the pupil"));
  }

  void plainLensHasNoTable() {
    RenderJob job = sampleView();
    QVERIFY(!plan(job).hasLens && says(job, "no lens model"));
    LensTables tables;
    QVERIFY(ViewRays(job, tables, serialRows).lens() == nullptr);
    QCOMPARE(worstDifference(job), 0);
    job.state.distortion.k1 = 0.1;
    QVERIFY(plan(job).hasLens && plan(job).isTableKept);
    QCOMPARE(worstDifference(job), 0);
  }

  void statesWithOneLensShareItsTable() {
    RenderJob job = sampleView();
    job.state.distortion.k1 = 0.1;
    LensTables tables;
    const ViewRays first(job, tables, serialRows);
    job.state.camera.eye = {0.1, 0, 0.7};
    const ViewRays moved(job, tables, serialRows);
    QVERIFY(first.lens() != nullptr && first.lens() == moved.lens());
    job.state.camera.res = {71, 50};
    QVERIFY(ViewRays(job, tables, serialRows).lens() != first.lens());
  }

  void aTableThatIsTooLargeIsNotKept() {
    RenderJob job = sampleView();
    job.state.distortion.k1 = 0.1;
    job.state.camera.res = {16384, 16384};
    QVERIFY(!plan(job).isTableKept && says(job, "the lens"));
  }

  void windowOfOneHasNoPsf() {
    RenderJob job = sampleView();
    QCOMPARE(plan(job).psfReach, 0);
    QVERIFY(says(job, "no light leakage") && plan(job).copiesTexels);
  }

  void tapsThatDoNotCountAreLeftOut() {
    RenderJob job = sampleView();
    job.state.psf = {0.5, 9};
    QVERIFY(plan(job).psfReach < 4);
    QVERIFY(says(job, "taps, not 81"));
    QVERIFY(worstDifference(job) <= 1);
    job.state.psf = {0.67, 5};
    QCOMPARE(plan(job).psfReach, 2);
    QVERIFY(worstDifference(job) <= 1);
  }

  void linearLightOnlyWhereSomethingIsSummed() {
    RenderJob job = sampleView();
    job.state.psf.light = LightModel::linear;
    QVERIFY(!plan(job).sumsLinear && says(job, "no decoding"));
    QCOMPARE(worstDifference(job), 0);
    job.state.psf.windowSize = 3;
    QVERIFY(plan(job).sumsLinear);
    QVERIFY(worstDifference(job) <= 1);
  }

  void theOutlineIsKnownForPlainLenses() {
    RenderJob job = sampleView();
    QVERIFY(plan(job).knowsOutline);
    job.state.camera.fov = 80;
    const Image image = simulate(job);
    const auto seen = std::count(image.seen.begin(), image.seen.end(), std::uint8_t{255});
    LensTables tables;
    QCOMPARE(ViewRays(job, tables, serialRows).count(), std::int64_t(seen));
    QVERIFY(seen > 200 && seen < 3000);
    QCOMPARE(worstDifference(job), 0);
    job.display.lens = HogelLensModel::equiangular;
    QVERIFY(!plan(job).knowsOutline);
    QCOMPARE(worstDifference(job), 0);
  }

  void stripsFindCellsWhereALensCopiesTexels() {
    RenderJob job = sampleView();
    QVERIFY(!plan(job).usesStrips);
    job.state.distortion.k1 = 0.1;
    QVERIFY(plan(job).usesStrips && says(job, "polynomials of strips"));
    QCOMPARE(worstDifference(job), 0);
    const auto usesStrips = [&job](void (*change)(RenderJob&)) {
      RenderJob other = job;
      change(other);
      return plan(other).usesStrips;
    };
    QVERIFY(!usesStrips([](RenderJob& other) { other.state.psf = {0.67, 3}; }));
    QVERIFY(!usesStrips([](RenderJob& other) { other.sampling.samplesPerPixel = 2; }));
    QVERIFY(
        !usesStrips([](RenderJob& other) { other.display.lens = HogelLensModel::equiangular; }));
    QVERIFY(!usesStrips([](RenderJob& other) { other.method.isSingle = true; }));
    QVERIFY(!usesStrips([](RenderJob& other) { other.state.camera.eye.z = -1; }));
  }

  void behindThePanelThereAreNoRays() {
    RenderJob job = sampleView();
    job.state.camera.eye.z = -1;
    QVERIFY(says(job, "no rays"));
    QCOMPARE(worstDifference(job), 0);
  }

  void theCertificateCountsWhatHasNoRay() {
    RenderJob job = sampleView();
    job.state.distortion = {0.2958943955272433, -1.0354662043042675};  // folds in the image
    job.state.camera.fov = 90;
    const LensCertificate lens = certify(lensKeyOf(job.state, job.sampling), serialRows);
    QCOMPARE(lens.pixels, std::size_t(70 * 50));
    std::size_t without = 0;
    const Camera camera(job.state.camera);
    const Distortion distortion(job.state.distortion);
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
