// SPDX-License-Identifier: BSD-3-Clause
// Speed against accuracy, measured within a budget: a trial of all costs, then errors, then times.
#include <algorithm>
#include <cmath>

#include "core/engine/scaled_view.h"
#include "core/metrics/squared_error.h"
#include "study/sampled_picture.h"
#include "study/tradeoff.h"

namespace hogelscope {

namespace {

/// Sums of errors over the views.
struct ErrorSum {
  double squares = 0;
  int largest = 0;
  double mismatches = 0;
  double pixels = 0;
};

void add(const Image& expected, const Image& image, const Band& band, ErrorSum& sum) {
  const auto width = std::size_t(image.width);
  const std::size_t first = std::size_t(band.begin) * width;
  const std::size_t last = std::size_t(band.end) * width;
  for (std::size_t k = 3 * first; k < 3 * last; ++k) {
    const int d = std::abs(int(image.rgb[k]) - int(expected.rgb[k]));
    sum.squares += double(d) * d;
    sum.largest = std::max(sum.largest, d);
  }
  for (std::size_t k = first; k < last; ++k)
    sum.mismatches += image.seen[k] != expected.seen[k] ? 1 : 0;
  sum.pixels += double(last - first);
}

std::string lensName(const NamedMethod& method) {
  if (method.mapping == LensMapping::direct) return "direct";
  const std::string steps = std::to_string(method.method.lensSteps);
  const LensInverse how = method.method.lens;
  if (how == LensInverse::newton) return "Newton " + steps;
  if (how == LensInverse::fixedPoint) return "fixed point " + steps;
  return how == LensInverse::table ? "table " + steps + " px" : "exact";
}

TradeoffRow rowOf(const NamedMethod& method, const ErrorSum& sum) {
  const double dropped = method.method.droppedTaps;
  TradeoffRow row;
  row.method = method.name;
  row.lens = lensName(method);
  row.reconstruction = nameOf(method.reconstruction);
  row.psf = std::isinf(dropped) ? "off" : dropped > Method{}.droppedTaps ? "truncated" : "full";
  row.samples = method.samplesPerPixel;
  row.scale = method.method.scale;
  row.precision = method.method.isSingle ? "float" : "double";
  row.rmse = std::sqrt(sum.squares / (3 * sum.pixels));
  row.psnr = psnr(sum.squares / (3 * sum.pixels));
  row.maxError = sum.largest;
  row.seenMismatch = sum.mismatches / sum.pixels;
  row.errorPixels = sum.pixels;
  row.isOfPupil = method.pupilSamples.has_value();
  row.isDefault = method.name == namedMethods().front().name;
  return row;
}

double pixelsOf(const RenderJob& job) {
  return double(job.state.camera.res[0]) * job.state.camera.res[1];
}

/// Returns the rays of one image, in millions.
double megaRays(const RenderJob& job) {
  const double n = job.sampling.samplesPerPixel;
  return n * n * double(plan(job).aperture.points.size()) * pixelsOf(reduced(job)) * 1e-6;
}

/// Whether the median is known to two per cent.
bool isSettled(const std::vector<double>& runs) {
  if (runs.size() < leastRuns) return false;
  TradeoffRow row;
  setTimes(row, runs);
  return spreadOf(row) <= 0.02;
}

/// The cost of an image, from one run on some pixels.
struct Cost {
  double seconds = 0;  ///< for all pixels
  int divisor = 1;     ///< divisor of the rendered image's sides
};

class Measurement {
 public:
  Measurement(const std::vector<RenderJob>& views, const Budget& budget,
              const ParallelRows& parallelRows, const Progress& progress, bool hasBoth)
      : m_methods(methodsFor(views)),
        m_questions{questionOf(views.front().sampling)},
        m_hasPupil(havePupil(views)),
        m_budget(budget),
        m_start(budget.clock()),
        m_parallelRows(parallelRows) {
    if (hasBoth)
      m_questions.push_back(m_questions.front() == Question::displayAsBuilt
                                ? Question::idealPicture
                                : Question::displayAsBuilt);
    for (const std::size_t k : spreadOrder(views.size())) m_views.push_back(views[k]);
    for (const RenderJob& job : views) m_pixels += pixelsOf(job);
    if (progress)
      m_pulse = [this, progress](double) {
        return progress(std::min(1.0, std::max(m_done, elapsed() / m_budget.seconds)));
      };
  }

  Tradeoff run() {
    look();
    m_done = trialShare;
    measureErrors();
    m_done = errorPart;
    return timed();
  }

 private:
  // Parts of the budget. No view's errors start after the limit, even if the trial was inaccurate.
  static constexpr double trialShare = 0.1;
  static constexpr double errorPart = 0.4;
  static constexpr double errorLimit = 0.5;
  static constexpr double planned = 0.8;  // of the time for runs: the trial is imprecise

  [[nodiscard]] double elapsed() const { return m_budget.clock() - m_start; }
  [[nodiscard]] double left(double part) const { return part * m_budget.seconds - elapsed(); }

  /// Renders from scratch, lens rays included.
  [[nodiscard]] Cost timedPicture(const RenderJob& job, int divisor) const {
    const RenderJob part = smaller(job, divisor);
    const double start = m_budget.clock();
    (void)Renderer(m_parallelRows).render(part, m_pulse);
    return {(m_budget.clock() - start) * pixelsOf(job) / pixelsOf(part), divisor};
  }

  [[nodiscard]] Image reference(Question question, const RenderJob& job, int step) const {
    NamedMethod method = question == Question::displayAsBuilt
                             ? NamedMethod{"display"}
                             : NamedMethod{"ideal", Reconstruction::quadrilinear, 8};
    if (question == Question::displayAsBuilt && !m_hasPupil)
      return sampledReference(applyMethod(method, job), step, m_parallelRows, m_pulse);
    if (m_hasPupil) method.pupilSamples = Aperture::mostSamples;
    Renderer renderer(m_parallelRows);
    return sampledPicture(applyMethod(method, job), step, renderer, m_pulse);
  }

  [[nodiscard]] Cost timedReference(const RenderJob& job, int divisor) const {
    const RenderJob part = smaller(job, divisor);
    const double start = m_budget.clock();
    for (const Question question : m_questions) (void)reference(question, part, 1);
    return {(m_budget.clock() - start) * pixelsOf(job) / pixelsOf(part), divisor};
  }

  /// Measures on few pixels, then on four times as many while these fit into `allowed` seconds.
  template <class Measure>
  static Cost costOf(double allowed, const Measure& measure) {
    Cost cost = measure(16);
    while (cost.divisor > 1 && 4 * cost.seconds <= allowed * cost.divisor * cost.divisor)
      cost = measure(cost.divisor / 2);
    return cost;
  }

  /// Measures the costs of all methods on as many views as fit.
  void look() {
    const double allowed = trialShare / 2 * m_budget.seconds / double(m_methods.size() + 1);
    m_trials.resize(m_methods.size());
    m_errorCosts.resize(m_methods.size() + 1);
    // Warms up code, pages, threads and the processor's clock.
    (void)timedPicture(applyMethod(m_methods.front(), m_views.front()), 16);
    double pixels = 0;
    for (const RenderJob& job : m_views) {
      if (pixels > 0 && left(trialShare) <= 0) break;
      pixels += pixelsOf(job);
      for (std::size_t m = 0; m < m_methods.size(); ++m) {
        const RenderJob used = applyMethod(m_methods[m], job);
        m_trials[m].push_back(
            costOf(allowed, [&](int divisor) { return timedPicture(used, divisor); }));
        PictureCost& cost = m_errorCosts[m + 1];
        (isSampled(used) ? cost.bands : cost.whole) += m_trials[m].back().seconds;
      }
      m_errorCosts.front().bands +=
          costOf(allowed, [&](int divisor) { return timedReference(job, divisor); }).seconds;
    }
    for (PictureCost& cost : m_errorCosts)
      cost = {cost.whole * m_pixels / pixels, cost.bands * m_pixels / pixels};
  }

  void measureErrors() {
    int coarsest = coarsestStep(m_views.front().state.camera.res[1]);
    for (const RenderJob& job : m_views)
      coarsest = std::min(coarsest, coarsestStep(job.state.camera.res[1]));
    const ErrorPlan plan = planErrors(m_errorCosts, coarsest, m_views.size(), left(errorPart));
    m_errors.assign(m_questions.size(), std::vector<ErrorSum>(m_methods.size()));
    for (std::size_t k = 0; k < plan.views; ++k) {
      if (k > 0 && left(errorLimit) <= 0) break;
      ++m_errorViews;
      const RenderJob& job = m_views[k];
      std::vector<Image> expected;
      for (const Question question : m_questions)
        expected.push_back(reference(question, job, plan.steps.front()));
      Renderer renderer(m_parallelRows);  // reuses the lens of methods that share one
      for (std::size_t m = 0; m < m_methods.size(); ++m) {
        const int step = plan.steps[m + 1];
        const RenderJob used = applyMethod(m_methods[m], job);
        const Image image = sampledPicture(used, step, renderer, m_pulse);
        for (std::size_t q = 0; q < expected.size(); ++q)
          for (const Band& band : sampledBands(image.height, step))
            add(expected[q], image, band, m_errors[q][m]);
      }
    }
  }

  Tradeoff timed() {
    std::vector<std::vector<double>> costs(m_methods.size());
    for (std::size_t m = 0; m < m_methods.size(); ++m)
      for (const Cost& cost : m_trials[m]) costs[m].push_back(cost.seconds);
    const TimePlan plan = planTimes(costs, planned * left(1));
    for (std::size_t m = 0; m < m_methods.size(); ++m)
      for (std::size_t k = 0; k < plan.views && !plan.repeats[m]; ++k)
        if (plan.divisors[m] < m_trials[m][k].divisor && left(1) > 0)
          m_trials[m][k] = timedPicture(applyMethod(m_methods[m], m_views[k]), plan.divisors[m]);
    m_done = (1 + errorPart) / 2;
    const std::vector<std::vector<double>> runs = repeated(plan);
    Tradeoff result;
    result.timedViews = plan.views;
    result.errorViews = m_errorViews;
    for (std::size_t q = 0; q < m_questions.size(); ++q) {
      std::vector<TradeoffRow>& rows = q == 0 ? result.rows : result.otherRows;
      for (std::size_t m = 0; m < m_methods.size(); ++m)
        rows.push_back(row(m, m_errors[q][m], runs[m], plan.views));
      markPareto(rows);
    }
    return result;
  }

  /// Returns milliseconds per image. The runs of all methods are interleaved, so that quiet moments
  /// of the machine favour none.
  [[nodiscard]] std::vector<std::vector<double>> repeated(const TimePlan& plan) {
    std::vector<std::vector<double>> runs(m_methods.size());
    const double before = m_done;
    for (int round = 0; round < mostRuns; ++round) {
      m_done = before + (1 - before) * round / mostRuns;
      for (std::size_t m = 0; m < m_methods.size(); ++m) {
        if (!plan.repeats[m] || isSettled(runs[m])) continue;
        if (left(1) <= 0) return runs;
        double sum = 0;
        for (std::size_t k = 0; k < plan.views; ++k)
          sum += timedPicture(applyMethod(m_methods[m], m_views[k]), 1).seconds;
        runs[m].push_back(1000 * sum / double(plan.views));
      }
    }
    return runs;
  }

  /// Returns a row; without runs the time is that of the trial.
  [[nodiscard]] TradeoffRow row(std::size_t m, const ErrorSum& error, std::vector<double> runs,
                                std::size_t views) const {
    TradeoffRow row = rowOf(m_methods[m], error);
    double rays = 0;
    double seconds = 0;
    double pixels = 0;
    for (std::size_t k = 0; k < views; ++k) {
      const RenderJob used = applyMethod(m_methods[m], m_views[k]);
      const int divisor = runs.empty() ? m_trials[m][k].divisor : 1;
      row.timedPixels += pixelsOf(smaller(used, divisor));
      rays += megaRays(used);
      seconds += m_trials[m][k].seconds;
      pixels += pixelsOf(used);
    }
    if (runs.empty()) runs.push_back(1000 * seconds / double(views));
    setTimes(row, runs);
    row.mraysPerSecond = rays / double(views) / row.milliseconds * 1000;
    row.isSampled = row.timedPixels < pixels || row.errorPixels < m_pixels;
    return row;
  }

  std::vector<RenderJob> m_views;  ///< in an order of which every prefix is spread over all
  std::vector<NamedMethod> m_methods;
  std::vector<Question> m_questions;  ///< the views' own first
  bool m_hasPupil;
  Budget m_budget;
  double m_start;
  const ParallelRows& m_parallelRows;
  Progress m_pulse;
  double m_done = 0;                        ///< the share done, if the work ends before the budget
  double m_pixels = 0;                      ///< of all views
  std::vector<std::vector<Cost>> m_trials;  ///< of each method and the first views
  std::vector<PictureCost> m_errorCosts;    ///< of all views, those of the references first
  std::vector<std::vector<ErrorSum>> m_errors;  ///< of each question and method
  std::size_t m_errorViews = 0;
};

}  // namespace

Tradeoff measureTradeoff(const std::vector<RenderJob>& views, const Budget& budget,
                         const ParallelRows& parallelRows, const Progress& progress, bool hasBoth) {
  for (const RenderJob& view : views) requireHogels(view.display, "a trade-off");
  return Measurement(views, budget, parallelRows, progress, hasBoth).run();
}

}  // namespace hogelscope
