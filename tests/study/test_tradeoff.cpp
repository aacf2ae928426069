// SPDX-License-Identifier: BSD-3-Clause
// Tests the comparison of methods: what is compared, its errors, its Pareto front.
#include "study/tradeoff.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/engine/fast_simulation.h"
#include "core/engine/scaled_view.h"
#include "tests/core/random_scene.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

/// Two small views of noise through a lens, with leakage.
std::vector<RenderJob> someViews(const SamplingParams& sampling = {}) {
  Random random(3);
  RandomScene scene;
  scene.content.size = {40, 40, 12, 12};
  fillWithNoise<std::uint8_t>(random, scene, 0, 256, 1);
  RenderJob job;
  job.lightField = scene.job.lightField;
  job.display.hogels = {40, 40};
  job.display.directions = {12, 12};
  job.sampling = sampling;
  job.state.camera.res = {48, 36};
  job.state.psf = {0.67, 5};
  job.state.distortion = {0.6, 0.4, 0, 0, 0.3};  // the paper's Fig. 1
  std::vector<RenderJob> views{job, job};
  views[1].state.camera.eye = {0.1, 0.05, 0.5};
  return views;
}

/// A clock that goes on by `tick` seconds whenever it is read, so that all take the same time.
Budget budgetOf(double seconds, double tick) {
  const auto now = std::make_shared<double>(0);
  return {seconds, [now, tick] { return *now += tick; }};
}

Budget ample() {
  return budgetOf(60, 1e-4);
}

const TradeoffRow& rowOf(const std::vector<TradeoffRow>& rows, const std::string& method) {
  for (const TradeoffRow& row : rows)
    if (row.method == method) return row;
  throw std::out_of_range(method);
}

}  // namespace

class TestTradeoff : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// More samples are nearer to the reference, and slower; a spiral is better than a grid.
  void samplesOfAPupilAreMethods() {
    std::vector<RenderJob> views = someViews();
    QVERIFY(!havePupil(views) && methodsFor(views).size() == namedMethods().size());
    for (RenderJob& job : views) {
      job.state.pupil = {0.15, 0, 0};
      job.state.psf = {};
    }
    QVERIFY(havePupil(views));
    const std::size_t all = namedMethods().size() + pupilMethods().size();
    QCOMPARE(methodsFor(views).size(), all);
    const std::vector<TradeoffRow> rows = measureTradeoff(views, ample(), serialRows, {}).rows;
    QCOMPARE(rows.size(), all);
    const auto psnr = [&](const char* method) { return rowOf(rows, method).psnr; };
    QVERIFY(psnr("pinhole") < psnr("Vogel spiral 4"));
    QVERIFY(psnr("Vogel spiral 4") < psnr("Vogel spiral 32"));
    QVERIFY(psnr("Vogel spiral 32") < psnr("Vogel spiral 112"));
    QVERIFY2(psnr("Vogel spiral 112") > psnr("grid 112") + 2 &&
                 psnr("Vogel spiral 112") > psnr("random 112") + 2,
             qPrintable(QString("%1 %2 %3")
                            .arg(psnr("Vogel spiral 112"))
                            .arg(psnr("grid 112"))
                            .arg(psnr("random 112"))));
    QVERIFY(rowOf(rows, "random 12").isOfPupil && !rowOf(rows, "exact").isOfPupil);
  }

  void methodsAreManyAndDiffer() {
    const std::vector<NamedMethod> methods = namedMethods();
    QVERIFY(methods.size() >= 20);
    std::set<std::string> names;
    const RenderJob job = someViews().front();
    for (std::size_t a = 0; a < methods.size(); ++a) {
      QVERIFY(names.insert(methods[a].name).second);
      for (std::size_t b = 0; b < a; ++b)
        QVERIFY(applyMethod(methods[a], job) != applyMethod(methods[b], job));
    }
    QCOMPARE(methods.front().name, std::string("exact"));
    const RenderJob byDefault = applyMethod(methods.front(), job);
    QVERIFY(byDefault.method == Method{} && byDefault.sampling == SamplingParams{});
  }

  /// "PSF off" and "exact, float" stay; one state with a lens is enough for all to stay.
  void withoutALensNoLensMethods() {
    auto views = someViews();
    views[0].state.distortion = {};
    QCOMPARE(methodsFor(views).size(), namedMethods().size());
    views[1].state.distortion = {};
    std::set<std::string> names;
    for (const TradeoffRow& row : measureTradeoff(views, ample(), parallelRows, {}).rows) {
      QCOMPARE(row.lens, std::string("exact"));
      names.insert(row.method);
    }
    QCOMPARE(names.size(), namedMethods().size() - 10);
    QVERIFY(names.contains("PSF off") && names.contains("exact, float"));
  }

  void theQuestionFollowsTheSampling() {
    QVERIFY(questionOf({}) == Question::displayAsBuilt);
    QVERIFY(questionOf({LensMapping::direct}) == Question::displayAsBuilt);
    QVERIFY(questionOf({.reconstruction = Reconstruction::bilinear}) == Question::idealPicture);
    QVERIFY(questionOf({.samplesPerPixel = 2}) == Question::idealPicture);
  }

  void initTestCase() { m_found = measureTradeoff(someViews(), ample(), parallelRows, {}); }

  void errorsAgainstTheDisplayAsBuilt() {
    const auto& rows = m_found.rows;
    const auto error = [&rows](const char* method) { return rowOf(rows, method).rmse; };
    QVERIFY(error("exact") < 0.01 && rowOf(rows, "exact").isDefault);
    QVERIFY(error("Newton 5") < 0.01);
    QVERIFY(error("fixed point 1") > error("fixed point 5"));
    QVERIFY(error("fixed point 5") > error("fixed point 20"));
    QVERIFY(error("table 16 px") > error("table 4 px"));
    QVERIFY(error("PSF off") > error("PSF truncated"));
    QVERIFY(error("direct") > 30 && rowOf(rows, "direct").seenMismatch > 0.01);
    QVERIFY(error("quarter size") > error("half size"));
    for (const TradeoffRow& row : rows) {
      QVERIFY(row.milliseconds > 0 && row.mraysPerSecond > 0);
      QVERIFY(row.maxError >= row.rmse);
      if (row.rmse > 0)
        QVERIFY(std::abs(row.psnr - 20 * std::log10(255 / row.rmse)) < 1e-9);
      else
        QVERIFY(std::isinf(row.psnr));
    }
  }

  /// The numbers themselves, of one method: from the reference engine, pixel by pixel.
  void errorsAreThoseOfThePictures() {
    const auto views = someViews();
    const auto& rows = m_found.rows;
    for (const NamedMethod& method : namedMethods()) {
      if (method.name != "half size" && method.name != "bilinear") continue;
      double squares = 0;
      double values = 0;
      for (const RenderJob& job : views) {
        const Image expected = simulate(job);
        const RenderJob used = applyMethod(method, job);
        Image image = rendered(reduced(used));
        if (used.method.scale > 1) image = enlarged(image, used.method.scale, job.state.camera.res);
        for (std::size_t k = 0; k < image.rgb.size(); ++k)
          squares += std::pow(image.rgb[k] - expected.rgb[k], 2);
        values += double(image.rgb.size());
      }
      QCOMPARE(rowOf(rows, method.name).rmse, std::sqrt(squares / values));
    }
  }

  void errorsAgainstTheIdealPicture() {
    const SamplingParams sampling{.reconstruction = Reconstruction::quadrilinear};
    const auto rows = measureTradeoff(someViews(sampling), ample(), parallelRows, {}).rows;
    const auto error = [&rows](const char* method) { return rowOf(rows, method).rmse; };
    QCOMPARE(error("quadrilinear 8×8"), 0.0);
    QVERIFY(error("quadrilinear 4×4") < error("quadrilinear 2×2"));
    QVERIFY(error("quadrilinear 2×2") < error("quadrilinear"));
    QVERIFY(error("quadrilinear") < error("exact"));
  }

  void errorsAreTheSameEveryTime() {
    const auto& first = m_found.rows;
    const auto second = measureTradeoff(someViews(), ample(), serialRows, {}).rows;
    for (std::size_t k = 0; k < first.size(); ++k) {
      QCOMPARE(second[k].rmse, first[k].rmse);
      QCOMPARE(second[k].maxError, first[k].maxError);
      QCOMPARE(second[k].seenMismatch, first[k].seenMismatch);
    }
  }

  void anAmpleBudgetMeasuresAllPixels() {
    QCOMPARE(m_found.timedViews, std::size_t(2));
    QCOMPARE(m_found.errorViews, std::size_t(2));
    for (const TradeoffRow& row : m_found.rows) {
      QCOMPARE(row.runs, leastRuns);  // all agree
      QVERIFY(!row.isSampled);
      QCOMPARE(row.timedPixels, 2 * 48.0 * 36);
      QCOMPARE(row.errorPixels, 2 * 48.0 * 36);
      QVERIFY(row.psnrLow == row.psnr && row.psnrHigh == row.psnr);
    }
  }

  /// Every row is there, and says on how few pixels.
  void aBudgetThatIsOverAtOnce() {
    auto views = someViews();
    for (RenderJob& view : views) view.state.camera.res = {16, 96};
    const Tradeoff tradeoff = measureTradeoff(views, budgetOf(1, 2), parallelRows, {});
    QCOMPARE(tradeoff.rows.size(), namedMethods().size());
    QCOMPARE(tradeoff.timedViews, std::size_t(1));
    QCOMPARE(tradeoff.errorViews, std::size_t(1));
    for (const TradeoffRow& row : tradeoff.rows) {
      QVERIFY(row.isSampled && row.milliseconds > 0 && std::isfinite(row.rmse));
      QCOMPARE(row.runs, 1);
      QVERIFY(std::isnan(spreadOf(row)));
      QCOMPARE(row.timedPixels, 6.0);        // 1×6 of 16×96
      QCOMPARE(row.errorPixels, 16.0 * 96);  // of one view, which says little of the other
      QVERIFY(row.psnrLow < row.psnr && row.psnrHigh >= row.psnr);
    }
  }

  /// Where pictures begin to take longer than the look said, no other one is begun.
  void theBudgetHoldsThoughTheLookWasWrong() {
    RenderJob view = someViews().front();
    view.state.camera.res = {8, 6};
    int readings = 0;
    const auto measured = [&](int slowFrom) {
      const auto now = std::make_shared<double>(0);
      readings = 0;
      const Budget budget{
          60, [&readings, now, slowFrom] { return *now += ++readings > slowFrom ? 20.0 : 1e-4; }};
      return measureTradeoff({view}, budget, parallelRows, {});
    };
    (void)measured(1000000);
    const int all = readings;
    const Tradeoff late = measured(all - 40);
    QVERIFY(std::ranges::any_of(late.rows,
                                [](const TradeoffRow& row) { return row.runs < leastRuns; }));
    QVERIFY2(readings < all - 30, qPrintable(QString("%1 of %2").arg(readings).arg(all)));
  }

  void noisyTimesAreRepeatedUntilTheMedianIsKnown() {
    QVERIFY(std::isnan(spreadOf({})));
    TradeoffRow row;
    setTimes(row, {10, 11, 12, 13, 14, 15, 16, 17, 18});
    QCOMPARE(row.lowerQuartile, 12.0);
    QCOMPARE(row.upperQuartile, 16.0);
    QCOMPARE(row.runs, 9);
    QCOMPARE(spreadOf(row), 1.57 * 4 / 3 / 14);
    const auto random = std::make_shared<Random>(5);
    const auto now = std::make_shared<double>(0);
    const Budget noisy{60, [=] { return *now += random->uniform(1e-4, 1.3e-4); }};
    RenderJob view = someViews().front();
    view.state.camera.res = {8, 6};
    int most = 0;
    for (const TradeoffRow& found : measureTradeoff({view}, noisy, parallelRows, {}).rows) {
      QVERIFY(found.runs >= leastRuns && found.runs <= mostRuns);
      QVERIFY(spreadOf(found) <= 0.02 || found.runs == mostRuns);
      most = std::max(most, found.runs);
    }
    QVERIFY(most > leastRuns);
  }

  void theParetoFront() {
    std::vector<TradeoffRow> rows(5);
    const double times[]{1, 2, 2, 3, 1};
    const double errors[]{5, 3, 4, 3, 5};
    for (std::size_t k = 0; k < 5; ++k) {
      rows[k].milliseconds = times[k];
      rows[k].rmse = errors[k];
    }
    markPareto(rows);
    const bool expected[]{true, true, false, false, true};  // equal rows are both on it
    for (std::size_t k = 0; k < 5; ++k) QCOMPARE(rows[k].isPareto, expected[k]);
  }

  void stopsWhenToldTo() {
    int calls = 0;
    const Progress stop = [&calls](double) { return ++calls < 5; };
    QVERIFY_THROWS_EXCEPTION(Cancelled,
                             (void)measureTradeoff(someViews(), ample(), parallelRows, stop));
    QCOMPARE(calls, 5);
  }

 private:
  Tradeoff m_found;  ///< of someViews(), all pixels
};

QTEST_APPLESS_MAIN(TestTradeoff)
#include "test_tradeoff.moc"
