// SPDX-License-Identifier: BSD-3-Clause
// Speed against accuracy, measured within a budget: a trial of all costs, then errors, then times.
#include <algorithm>
#include <cmath>

#include "core/engine/scaled_view.h"
#include "core/metrics/squared_error.h"
#include "study/sampled_errors.h"
#include "study/tradeoff.h"

namespace hogelscope {

namespace {

std::string lensName(const NamedMethod& method) {
  if (method.mapping == LensMapping::direct) return "direct";
  const std::string steps = std::to_string(method.method.lensSteps);
  const LensInverse how = method.method.lens;
  if (how == LensInverse::newton) return "Newton " + steps;
  if (how == LensInverse::fixedPoint) return "fixed point " + steps;
  return how == LensInverse::table ? "table " + steps + " px" : "exact";
}

TradeoffRow rowOf(const NamedMethod& method, const MethodError& error, double pixels) {
  const double dropped = method.method.droppedTaps;
  TradeoffRow row;
  row.method = method.name;
  row.lens = lensName(method);
  row.reconstruction = nameOf(method.reconstruction);
  row.psf = std::isinf(dropped) ? "off" : dropped > Method{}.droppedTaps ? "truncated" : "full";
  row.samples = method.samplesPerPixel;
  row.scale = method.method.scale;
  row.precision = method.method.isSingle ? "float" : "double";
  row.rmse = std::sqrt(error.square);
  row.psnr = psnr(error.square);
  row.psnrLow = psnr(error.high);
  row.psnrHigh = psnr(error.low);
  row.maxError = error.largest;
  row.seenMismatch = error.mismatches;
  row.errorPixels = pixels;
  row.isOfPupil = method.pupilSamples.has_value();
  row.isDefault = method.name == namedMethods().front().name;
  return row;
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

/// Returns the view with sides divided by `divisor`, at least one pixel each.
RenderJob smaller(const RenderJob& job, int divisor) {
  RenderJob result = job;
  std::array<int, 2> res = job.state.camera.res;
  for (int& side : res) side = std::max(1, side / divisor);
  result.state = resized(job.state, res);
  return result;
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
  // The parts of the budget that have passed at the end of each step.
  static constexpr double trialShare = 0.1;
  static constexpr double errorPart = 0.4;
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
    const double allowed = trialShare / 2 * m_budget.seconds / double(m_methods.size());
    m_trials.resize(m_methods.size());
    // Warms up code, pages, threads and the processor's clock.
    (void)timedPicture(applyMethod(m_methods.front(), m_views.front()), 16);
    for (const RenderJob& job : m_views) {
      if (!m_trials.front().empty() && left(trialShare) <= 0) break;
      for (std::size_t m = 0; m < m_methods.size(); ++m) {
        const RenderJob used = applyMethod(m_methods[m], job);
        m_trials[m].push_back(
            costOf(allowed, [&](int divisor) { return timedPicture(used, divisor); }));
      }
    }
  }

  /// Draws blocks of all views, four times as many each time, until the errors are known or as long
  /// as there is time.
  void measureErrors() {
    SampledErrors errors(m_methods, m_questions, m_pixels, m_budget.seed, m_parallelRows, m_pulse);
    constexpr double enough = 0.3;  // dB
    double before = elapsed();
    for (const RenderJob& job : m_views) {
      if (m_errorViews > 0 && left(errorPart) <= 0) break;
      errors.add(job);
      ++m_errorViews;
    }
    double perRound = elapsed() - before;
    while (errors.rounds() < drawRounds && !errors.areKnown(enough)) {
      const double fitting = std::max(left(errorPart), 0.0) / perRound;
      const int rounds = int(std::min(3.0 * errors.rounds(), fitting));
      if (rounds < 1 && !errors.areFew()) break;
      const int drawn = errors.rounds();
      before = elapsed();
      errors.draw(std::max(rounds, 1));
      perRound = (elapsed() - before) / (errors.rounds() - drawn);
    }
    m_errorPixels = errors.pixels();
    for (const Question question : m_questions) m_errors.push_back(errors.errors(question));
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
  [[nodiscard]] TradeoffRow row(std::size_t m, const MethodError& error, std::vector<double> runs,
                                std::size_t views) const {
    TradeoffRow row = rowOf(m_methods[m], error, m_errorPixels);
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
  Budget m_budget;
  double m_start;
  const ParallelRows& m_parallelRows;
  Progress m_pulse;
  double m_done = 0;                        ///< the share done, if the work ends before the budget
  double m_pixels = 0;                      ///< of all views
  std::vector<std::vector<Cost>> m_trials;  ///< of each method and the first views
  std::vector<std::vector<MethodError>> m_errors;  ///< of each question and method
  double m_errorPixels = 0;
  std::size_t m_errorViews = 0;
};

}  // namespace

Tradeoff measureTradeoff(const std::vector<RenderJob>& views, const Budget& budget,
                         const ParallelRows& parallelRows, const Progress& progress, bool hasBoth) {
  for (const RenderJob& view : views) requireHogels(view.display, "a trade-off");
  return Measurement(views, budget, parallelRows, progress, hasBoth).run();
}

}  // namespace hogelscope
