// SPDX-License-Identifier: BSD-3-Clause
// sampling.tolerance: the cheapest way to a picture whose error is small enough.
#include "core/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "core/scaled_view.h"

namespace hogelscope {

namespace {

/// Neighbouring pixels [x0, x1) of row y: rays work in batches.
struct Run {
  int y;
  int x0;
  int x1;
};

/// About 3 % of the picture in runs spread evenly over it, each at a random place of its share; at
/// least 512 of them, or all there are.
std::vector<Run> probeRuns(const std::array<int, 2>& res) {
  constexpr int length = 8;
  constexpr int least = 512;
  constexpr double part = 0.03;
  const int perRow = (res[0] + length - 1) / length;
  const int all = perRow * res[1];
  const int count = std::min(all, std::max(least, int(part * all)));
  std::mt19937_64 random(20260722);
  std::vector<Run> runs;
  for (int k = 0; k < count; ++k) {
    const auto first = int(std::int64_t(all) * k / count);
    const auto next = int(std::int64_t(all) * (k + 1) / count);
    const int at = first + int(random() % std::uint64_t(next - first));
    const int x0 = at % perRow * length;
    runs.push_back({at / perRow, x0, std::min(x0 + length, res[0])});
  }
  return runs;
}

/// Renders the pixels of runs, and for a smaller picture those around them.
class Prober {
 public:
  Prober(const View& asked, LensTables& tables, const ParallelRows& parallelRows)
      : m_scale(asked.method.scale),
        m_simulation(reduced(asked), tables, parallelRows),
        m_image((asked.state.camera.res[0] + m_scale - 1) / m_scale,
                (asked.state.camera.res[1] + m_scale - 1) / m_scale) {}

  void render(const Run& run) {
    if (m_scale == 1) return row(run.y, run.x0, run.x1);
    const int first = std::max(run.x0 / m_scale - 1, 0);
    const int last = std::min(run.x1 / m_scale + 2, m_image.width);
    const int bottom = std::min(run.y / m_scale + 1, m_image.height - 1);
    for (int y = std::max(run.y / m_scale - 1, 0); y <= bottom; ++y) row(y, first, last);
  }

  [[nodiscard]] const Image& image() const { return m_image; }

 private:
  void row(int y, int x0, int x1) {
    const std::size_t at = std::size_t(y) * std::size_t(m_image.width) + std::size_t(x0);
    m_simulation.row(y, x0, x1, &m_image.rgb[3 * at], &m_image.seen[at]);
  }

  int m_scale;
  FastSimulation m_simulation;
  Image m_image;  ///< black but for what was rendered
};

double squaredError(const Run& run, const Image& reference, const Image& image, int scale) {
  double sum = 0;
  for (int x = run.x0; x < run.x1; ++x) {
    const auto rgb = enlargedPixel(image, scale, x, run.y);
    const std::size_t at = 3 * (std::size_t(run.y) * std::size_t(reference.width) + std::size_t(x));
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = double(rgb[c]) - double(reference.rgb[at + c]);
      sum += d * d;
    }
  }
  return sum / 3 / (run.x1 - run.x0);
}

/// Mean squared errors, of the probe and as a limit for the picture.
struct Estimate {
  double mean = 0;
  double limit = 0;
};

/// Runs are the independent samples. Three standard errors, and twice as much again as the worst
/// run gives to the mean: errors that are rare are met by few of the runs.
Estimate estimate(const std::vector<double>& errors, bool isWhole) {
  const auto n = double(errors.size());
  double sum = 0;
  double squares = 0;
  double worst = 0;
  for (const double error : errors) {
    sum += error;
    squares += error * error;
    worst = std::max(worst, error);
  }
  const double mean = sum / n;
  if (isWhole) return {mean, mean};
  const double deviation = std::sqrt(std::max(0.0, squares / n - mean * mean));
  return {mean, mean + 3 * deviation / std::sqrt(n) + 2 * worst / n};
}

/// Texels that are read, and for each ray the work of one more.
double cost(const View& view) {
  const Plan made = plan(view);
  const int window = 2 * made.psfReach + 1;
  const int corners = 1 << 2 * static_cast<int>(view.sampling.reconstruction);
  const double samples = view.sampling.samplesPerPixel;
  return (1 + double(corners) * window * window) * samples * samples / view.method.scale /
         view.method.scale;
}

/// All that is cheaper than the view in one thing or several, from the cheapest on.
std::vector<View> cheaper(const View& view) {
  std::vector<double> dropped{Method{}.droppedTaps};
  for (int reach = (view.state.psf.windowSize - 1) / 2; reach-- > 0;)
    dropped.push_back(1.001 * leakageLoss(view.state.psf, reach) + Method{}.droppedTaps);
  std::vector<View> views;
  for (const int scale : {1, 2, 4})
    for (int how = 0; how <= static_cast<int>(view.sampling.reconstruction); ++how)
      for (int n = view.sampling.samplesPerPixel; n >= 1; n /= 2)
        for (const double taps : dropped) {
          View candidate = view;
          candidate.sampling.reconstruction = static_cast<Reconstruction>(how);
          candidate.sampling.samplesPerPixel = n;
          candidate.method.droppedTaps = taps;
          candidate.method.scale = scale;
          views.push_back(candidate);
        }
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < views.size(); ++k) order.emplace_back(cost(views[k]), k);
  std::sort(order.begin(), order.end());
  std::vector<View> sorted;
  for (std::size_t k = 0; k < order.size(); ++k)
    if (k == 0 || order[k].first > order[k - 1].first) sorted.push_back(views[order[k].second]);
  return sorted;
}

}  // namespace

namespace {

/// Mean squared errors of the runs; fewer as soon as their mean is certainly above `allowed`.
std::vector<double> probe(const View& candidate, const std::vector<Run>& runs,
                          const Image& reference, double allowed, LensTables& tables,
                          const ParallelRows& parallelRows) {
  Prober prober(candidate, tables, parallelRows);
  std::vector<double> errors;
  double sum = 0;
  for (const Run& run : runs) {
    prober.render(run);
    errors.push_back(squaredError(run, reference, prober.image(), candidate.method.scale));
    sum += errors.back();
    if (sum > allowed * double(runs.size())) break;
  }
  return errors;
}

}  // namespace

Choice choose(const View& view, LensTables& tables, const ParallelRows& parallelRows) {
  Choice choice{view};
  if (!(view.sampling.tolerance > 0) || view.method != Method{}) return choice;
  const std::array<int, 2>& res = view.state.camera.res;
  const std::vector<Run> runs = probeRuns(res);
  for (const Run& run : runs) choice.pixels += run.x1 - run.x0;
  const bool isWhole = choice.pixels == res[0] * res[1];
  Prober reference(view, tables, parallelRows);
  for (const Run& run : runs) reference.render(run);
  const double allowed = view.sampling.tolerance * view.sampling.tolerance;
  for (const View& candidate : cheaper(view)) {
    const std::vector<double> errors =
        probe(candidate, runs, reference.image(), allowed, tables, parallelRows);
    if (errors.size() < runs.size()) continue;
    const auto [mean, limit] = estimate(errors, isWhole);
    if (limit > allowed) continue;
    choice.view = candidate;
    choice.rmse = std::sqrt(mean);
    choice.limit = std::sqrt(limit);
    break;
  }
  return choice;
}

std::string text(const Choice& choice) {
  constexpr std::array names{"nearest", "bilinear", "quadrilinear"};
  const SamplingParams& sampling = choice.view.sampling;
  const Plan made = plan(choice.view);
  std::array<char, 300> line{};
  std::snprintf(
      line.data(), line.size(),
      "%s, %d×%d rays a pixel, %d tap(s), %s; RMS error %.3g code values over a probe of %d "
      "pixels, at most %.3g with 99 %% confidence",
      names[static_cast<std::size_t>(sampling.reconstruction)], sampling.samplesPerPixel,
      sampling.samplesPerPixel, (2 * made.psfReach + 1) * (2 * made.psfReach + 1),
      choice.view.method.scale == 1   ? "full size"
      : choice.view.method.scale == 2 ? "half size, scaled up"
                                      : "quarter size, scaled up",
      choice.rmse, choice.pixels, choice.limit);
  return line.data();
}

}  // namespace hogelscope
