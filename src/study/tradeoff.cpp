// SPDX-License-Identifier: BSD-3-Clause
// Speed against accuracy, measured.
#include "study/tradeoff.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/text.h"
#include "core/engine/renderer.h"
#include "core/engine/scaled_view.h"
#include "core/metrics/squared_error.h"

namespace hogelscope {

Question questionOf(const SamplingParams& sampling) {
  return sampling.reconstruction == Reconstruction::nearest && sampling.samplesPerPixel == 1
             ? Question::displayAsBuilt
             : Question::idealPicture;
}

std::string questionText(Question question) {
  return question == Question::displayAsBuilt ? "the display as built" : "the ideal picture";
}

std::string details(Question question) {
  return question == Question::displayAsBuilt
             ? "exact lens, full window, nearest, one ray a pixel, double precision"
             : "exact lens, full window, quadrilinear, 8×8 rays a pixel, double precision";
}

RenderJob applyMethod(const NamedMethod& method, const RenderJob& job) {
  RenderJob result = job;
  result.sampling = {method.mapping, method.reconstruction, method.samplesPerPixel};
  result.method = method.method;
  return result;
}

namespace {

/// Renders from scratch, lens rays included.
Image render(const RenderJob& job, const ParallelRows& parallelRows, const Progress& progress) {
  return Renderer(parallelRows).render(job, progress);
}

Image reference(const RenderJob& job, Question question, const ParallelRows& parallelRows,
                const Progress& progress) {
  if (question == Question::idealPicture)
    return render(applyMethod({"ideal", Reconstruction::quadrilinear, 8}, job), parallelRows,
                  progress);
  const Simulation simulation(applyMethod({"display"}, job));
  const auto [width, height] = job.state.camera.res;
  Image image(width, height);
  const Progress heard = forThreads(progress);
  parallelRows(height, [&, columns = width](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < columns; ++x) {
        hearStop(heard);
        simulation.render(x, y, image);
      }
  });
  return image;
}

/// Sums over the views.
struct ErrorSum {
  double squares = 0;
  double values = 0;
  int largest = 0;
  double mismatches = 0;
  double pixels = 0;
};

void add(const Image& expected, const Image& image, ErrorSum& sum) {
  for (std::size_t k = 0; k < expected.rgb.size(); ++k) {
    const int d = std::abs(int(image.rgb[k]) - int(expected.rgb[k]));
    sum.squares += double(d) * d;
    sum.largest = std::max(sum.largest, d);
  }
  for (std::size_t k = 0; k < expected.seen.size(); ++k)
    sum.mismatches += image.seen[k] != expected.seen[k] ? 1 : 0;
  sum.values += double(expected.rgb.size());
  sum.pixels += double(expected.pixelCount());
}

std::string lensName(const NamedMethod& method) {
  if (method.mapping == LensMapping::direct) return "direct";
  const std::string steps = std::to_string(method.method.lensSteps);
  switch (method.method.lens) {
    case LensInverse::newton:
      return "Newton " + steps;
    case LensInverse::fixedPoint:
      return "fixed point " + steps;
    case LensInverse::table:
      return "table " + steps + " px";
    default:
      return "exact";
  }
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
  row.rmse = std::sqrt(sum.squares / sum.values);
  row.psnr = psnr(sum.squares / sum.values);
  row.maxError = sum.largest;
  row.seenMismatch = sum.mismatches / sum.pixels;
  row.isDefault = method.name == namedMethods().front().name;
  return row;
}

/// Returns the wall time in milliseconds.
double timed(const RenderJob& job, const ParallelRows& parallelRows, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  (void)render(job, parallelRows, progress);
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

/// Returns the rays of one image, in millions.
double megaRays(const RenderJob& job) {
  const RenderJob small = reduced(job);
  const double n = small.sampling.samplesPerPixel;
  return n * n * small.state.camera.res[0] * small.state.camera.res[1] * 1e-6;
}

/// All methods' rows without times, and the time of one round of all views in ms.
double measureErrors(const std::vector<RenderJob>& views, const ParallelRows& parallelRows,
                     const Progress& progress, std::vector<TradeoffRow>& rows) {
  const std::vector<NamedMethod> methods = methodsFor(views);
  std::vector<ErrorSum> sums(methods.size());
  const auto start = std::chrono::steady_clock::now();
  const Question question = questionOf(views.front().sampling);
  for (std::size_t k = 0; k < views.size(); ++k) {
    double done = double(k) / double(views.size());
    const Progress pulse = [&progress, &done](double) { return !progress || progress(done); };
    const Image expected = reference(views[k], question, parallelRows, pulse);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      done = (double(k) + double(m) / double(methods.size())) / double(views.size());
      add(expected, render(applyMethod(methods[m], views[k]), parallelRows, pulse), sums[m]);
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m) rows.push_back(rowOf(methods[m], sums[m]));
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

constexpr double longestRound = 6000;  // milliseconds
constexpr int leastRuns = 5;
constexpr int mostRuns = 25;

/// Picks evenly spread views, as many as a round has time for.
std::vector<RenderJob> someOf(const std::vector<RenderJob>& views, double millisecondsForAll) {
  const auto wanted = double(views.size()) * longestRound / millisecondsForAll;
  const std::size_t count = std::clamp<std::size_t>(std::size_t(wanted), 1, views.size());
  std::vector<RenderJob> some;
  for (std::size_t k = 0; k < count; ++k) some.push_back(views[k * views.size() / count]);
  return some;
}

}  // namespace

void setTimes(TradeoffRow& row, std::vector<double> runs) {
  std::sort(runs.begin(), runs.end());
  const std::size_t count = runs.size();
  row.milliseconds = (runs[(count - 1) / 2] + runs[count / 2]) / 2;
  row.fastest = runs.front();
  row.upperQuartile = runs[(3 * count + 3) / 4 - 1];
}

void markPareto(std::vector<TradeoffRow>& rows) {
  for (TradeoffRow& row : rows)
    row.isPareto = std::none_of(rows.begin(), rows.end(), [&row](const TradeoffRow& other) {
      return other.milliseconds <= row.milliseconds && other.rmse <= row.rmse &&
             (other.milliseconds < row.milliseconds || other.rmse < row.rmse);
    });
}

Tradeoff measureTradeoff(const std::vector<RenderJob>& views, const ParallelRows& parallelRows,
                         const Progress& progress) {
  Tradeoff result;
  // The first round warms up: code, pages, the processor's clock.
  const double round = measureErrors(views, parallelRows, part(progress, 0, 0.4), result.rows);
  const std::vector<RenderJob> timedOnes = someOf(views, round);
  result.timedViews = timedOnes.size();
  const double timedRound = round * double(timedOnes.size()) / double(views.size());
  result.runs = std::clamp(int(2 * longestRound / timedRound), leastRuns, mostRuns);
  const std::vector<NamedMethod> methods = methodsFor(views);
  std::vector<std::vector<double>> times(methods.size());
  for (int run = 0; run < result.runs; ++run)
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const double done = 0.4 + 0.6 * (run + double(m) / double(methods.size())) / result.runs;
      const Progress pulse = part(progress, done, done);
      double sum = 0;
      for (const RenderJob& job : timedOnes)
        sum += timed(applyMethod(methods[m], job), parallelRows, pulse);
      times[m].push_back(sum / double(timedOnes.size()));
    }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    TradeoffRow& row = result.rows[m];
    setTimes(row, times[m]);
    double rays = 0;
    for (const RenderJob& job : timedOnes) rays += megaRays(applyMethod(methods[m], job));
    row.mraysPerSecond = rays / double(timedOnes.size()) / row.milliseconds * 1000;
  }
  markPareto(result.rows);
  return result;
}

std::string csv(const std::vector<TradeoffRow>& rows) {
  std::string text =
      "method,lens,reconstruction,psf,samples,scale,precision,milliseconds,mrays_per_s,rmse,psnr,"
      "max_error,seen_mismatch,pareto,milliseconds_min,milliseconds_q75\n";
  for (const TradeoffRow& row : rows) {
    for (const std::string& word : {row.method, row.lens, row.reconstruction, row.psf})
      text += "\"" + word + "\",";
    text += std::to_string(row.samples) + "," + std::to_string(row.scale) + "," + row.precision;
    for (const double value :
         {row.milliseconds, row.mraysPerSecond, row.rmse, row.psnr, row.maxError, row.seenMismatch})
      text += "," + numberText(value);
    text += std::string(row.isPareto ? ",1," : ",0,") + numberText(row.fastest) + "," +
            numberText(row.upperQuartile) + "\n";
  }
  return text;
}

}  // namespace hogelscope
