// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/adaptive_method.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>

#include "core/engine/scaled_view.h"

namespace hogelscope {

namespace {

/// Picks about 3 % of the image in runs spread evenly over it, each at a random place of its part;
/// at least 512 of them, or all. They are runs of neighbours, since rays are cast in batches.
std::vector<PixelRun> probeRuns(const std::array<int, 2>& res) {
  constexpr int length = 8;
  constexpr int least = 512;
  constexpr double part = 0.03;
  const int perRow = (res[0] + length - 1) / length;
  const int all = perRow * res[1];
  const int count = std::min(all, std::max(least, int(part * all)));
  std::mt19937_64 random(20260722);
  std::vector<PixelRun> runs;
  for (int k = 0; k < count; ++k) {
    const auto first = int(std::int64_t(all) * k / count);
    const auto next = int(std::int64_t(all) * (k + 1) / count);
    const int at = first + int(random() % std::uint64_t(next - first));
    const int x0 = at % perRow * length;
    runs.push_back({at / perRow, x0, std::min(x0 + length, res[0])});
  }
  return runs;
}

/// Renders the pixels of runs, and for a reduced image also those around them.
class Prober {
 public:
  Prober(const RenderJob& asked, LensTables& tables, const ParallelRows& parallelRows,
         const Progress& progress)
      : m_scale(asked.method.scale),
        m_simulation(reduced(asked), tables, parallelRows, progress),
        m_image((asked.state.camera.res[0] + m_scale - 1) / m_scale,
                (asked.state.camera.res[1] + m_scale - 1) / m_scale) {}

  void render(const PixelRun& run) {
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
    m_simulation.rows(y, y + 1, x0, x1, &m_image.rgb[3 * at], &m_image.seen[at]);
  }

  int m_scale;
  FastSimulation m_simulation;
  Image m_image;  ///< black where nothing was rendered
};

/// The result of one run.
struct RunError {
  double squares = 0;  ///< over pixels and channels
  int pixels = 0;
};

RunError errorOf(const PixelRun& run, const Image& reference, const Image& image, int scale) {
  RunError error{0, run.x1 - run.x0};
  for (int x = run.x0; x < run.x1; ++x) {
    const auto rgb = enlargedPixel(image, scale, x, run.y);
    const std::size_t at = 3 * (std::size_t(run.y) * std::size_t(reference.width) + std::size_t(x));
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = double(rgb[c]) - double(reference.rgb[at + c]);
      error.squares += d * d;
    }
  }
  return error;
}

/// The mean squared error of the probe, and its limit for the image.
struct Estimate {
  double mean = 0;
  double limit = 0;
};

/// Estimates the error from runs, the independent samples of a ratio, squares over pixels. The
/// limit is three standard errors above it, plus twice the worst run's part of the mean, since few
/// of the runs meet errors that are rare.
Estimate estimate(const std::vector<RunError>& errors, bool isWhole) {
  double squares = 0;
  double values = 0;
  double worst = 0;
  for (const RunError& error : errors) {
    squares += error.squares;
    values += 3.0 * error.pixels;
    worst = std::max(worst, error.squares);
  }
  const double mean = squares / values;
  if (isWhole) return {mean, mean};
  double deviations = 0;
  for (const RunError& error : errors) {
    const double d = error.squares - mean * 3 * error.pixels;
    deviations += d * d;
  }
  return {mean, mean + (3 * std::sqrt(deviations) + 2 * worst) / values};
}

/// Estimates the time of an image, in units of one summed texel: a copied texel costs less than
/// one, a ray that sums costs more than its texels, and so does each pixel of an image scaled up.
double cost(const RenderJob& job) {
  constexpr double copying = 1;
  constexpr double summing = 4;
  constexpr double enlarging = 3;
  const Plan made = plan(job);
  const int window = 2 * made.psfReach + 1;
  const int corners = 1 << 2 * static_cast<int>(job.sampling.reconstruction);
  double ray = made.copiesTexels ? copying : summing + double(corners) * window * window;
  const double samples = job.sampling.samplesPerPixel;
  const double scale = job.method.scale;
  if (!made.aperture.isPinhole) ray = double(made.aperture.points.size()) * (summing + ray);
  return ray * samples * samples / scale / scale + (scale > 1 ? enlarging : 0);
}

/// Returns the view's pupil, and where its samples are counted automatically, ones of fewer.
std::vector<PupilParams> pupilsOf(const RenderJob& job) {
  std::vector<PupilParams> pupils{job.state.pupil};
  const Aperture aperture = plan(job).aperture;
  if (aperture.isPinhole || job.state.pupil.samples > 0) return pupils;
  for (int samples = int(aperture.points.size()) / 2; samples > 1; samples /= 2) {
    pupils.push_back(job.state.pupil);
    pupils.back().samples = samples;
  }
  pupils.emplace_back();
  return pupils;
}

/// Returns all views that are cheaper in one or several respects, the cheapest first.
std::vector<RenderJob> cheaper(const RenderJob& job) {
  std::vector<double> dropped{Method{}.droppedTaps};
  for (int reach = (job.state.psf.windowSize - 1) / 2; reach-- > 0;)
    dropped.push_back(1.001 * leakageLoss(job.state.psf, reach) + Method{}.droppedTaps);
  std::vector<std::pair<double, PupilParams>> cheaperLight;
  for (const PupilParams& pupil : pupilsOf(job))
    for (const double taps : dropped) cheaperLight.emplace_back(taps, pupil);
  std::vector<std::pair<double, RenderJob>> views;
  for (const int scale : {1, 2, 4})
    for (int how = 0; how <= static_cast<int>(job.sampling.reconstruction); ++how)
      for (int n = job.sampling.samplesPerPixel; n >= 1; n /= 2)
        for (const auto& [taps, pupil] : cheaperLight) {
          RenderJob candidate = job;
          candidate.state.pupil = pupil;
          candidate.sampling.reconstruction = static_cast<Reconstruction>(how);
          candidate.sampling.samplesPerPixel = n;
          candidate.method.droppedTaps = taps;
          candidate.method.scale = scale;
          views.emplace_back(cost(candidate), candidate);
        }
  const double most = cost(job);
  std::ranges::stable_sort(views, {}, &std::pair<double, RenderJob>::first);
  std::vector<RenderJob> sorted;
  for (const auto& [costs, candidate] : views)
    if (costs < most) sorted.push_back(candidate);
  return sorted;
}

/// The least number of seen pixels that is representative; an image with fewer is cheap anyway.
constexpr int leastSeen = 500;

class Probe {
 public:
  Probe(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
        const Progress& progress)
      : m_res(job.state.camera.res),
        m_runs(probeRuns(m_res)),
        m_tables(tables),
        m_parallelRows(parallelRows),
        m_progress(progress) {
    for (const PixelRun& run : m_runs) m_pixels += run.x1 - run.x0;
    Prober prober(job, m_tables, m_parallelRows, m_progress);
    m_parallelRows(int(m_runs.size()), [&](int begin, int end) {
      for (int k = begin; k < end; ++k) prober.render(m_runs[std::size_t(k)]);
    });
    m_reference = prober.image();
  }

  [[nodiscard]] int pixels() const { return m_pixels; }
  [[nodiscard]] bool saysEnough() const {
    return isWhole() || std::count(m_reference.seen.begin(), m_reference.seen.end(),
                                   std::uint8_t{255}) >= leastSeen;
  }

  /// Returns the error of a view; none as soon as it is certainly above `allowed`, a mean square.
  [[nodiscard]] std::optional<Estimate> measure(const RenderJob& candidate, double allowed) const {
    constexpr int parts = 4;
    Prober prober(candidate, m_tables, m_parallelRows, m_progress);
    // Runs of a view that is enlarged share its few pixels.
    const ParallelRows rows = candidate.method.scale == 1 ? m_parallelRows : serialRows;
    std::vector<RunError> errors(m_runs.size());
    const auto count = int(m_runs.size());
    for (int part = 0; part < parts; ++part) {
      const int first = count * part / parts;
      rows(count * (part + 1) / parts - first, [&](int begin, int end) {
        const std::size_t last = std::size_t(first) + std::size_t(end);
        for (std::size_t k = std::size_t(first) + std::size_t(begin); k < last; ++k) {
          prober.render(m_runs[k]);
          errors[k] = errorOf(m_runs[k], m_reference, prober.image(), candidate.method.scale);
        }
      });
      double squares = 0;
      for (const RunError& error : errors) squares += error.squares;
      if (squares > allowed * 3 * m_pixels) return std::nullopt;
    }
    const Estimate found = estimate(errors, isWhole());
    return found.limit <= allowed ? std::optional(found) : std::nullopt;
  }

 private:
  [[nodiscard]] bool isWhole() const { return m_pixels == m_res[0] * m_res[1]; }

  std::array<int, 2> m_res;
  std::vector<PixelRun> m_runs;
  LensTables& m_tables;
  const ParallelRows& m_parallelRows;
  const Progress& m_progress;
  Image m_reference;  ///< black outside the runs
  int m_pixels = 0;
};

}  // namespace

Choice chooseMethod(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                    const Progress& progress) {
  Choice choice{job};
  if (!(job.sampling.tolerance > 0) || job.method != Method{}) return choice;
  checkContent(job);
  choice.job.sampling.tolerance = 0;  // resolved
  const std::vector<RenderJob> candidates = cheaper(choice.job);
  if (candidates.empty()) return choice;
  const Probe probe(choice.job, tables, parallelRows, progress);
  choice.pixels = probe.pixels();
  if (!probe.saysEnough()) return choice;
  const double allowed = job.sampling.tolerance * job.sampling.tolerance;
  for (const RenderJob& candidate : candidates) {
    const std::optional<Estimate> found = probe.measure(candidate, allowed);
    if (!found) continue;
    choice.job = candidate;
    choice.rmse = std::sqrt(found->mean);
    choice.limit = std::sqrt(found->limit);
    break;
  }
  return choice;
}

std::string choiceText(const Choice& choice) {
  if (choice.pixels == 0) return "nothing is cheaper";
  const SamplingParams& sampling = choice.job.sampling;
  const Plan made = plan(choice.job);
  const std::size_t points = made.aperture.points.size();
  const std::string pupil =
      made.aperture.isPinhole ? "" : std::to_string(points) + " samples of the pupil, ";
  std::array<char, 300> line{};
  std::snprintf(
      line.data(), line.size(),
      "%s, %d×%d rays a pixel, %s%d tap(s), %s; RMS error %.3g code values over a probe of %d "
      "pixels, at most %.3g with 99 %% confidence",
      nameOf(sampling.reconstruction).data(), sampling.samplesPerPixel, sampling.samplesPerPixel,
      pupil.c_str(), (2 * made.psfReach + 1) * (2 * made.psfReach + 1),
      choice.job.method.scale == 1   ? "full size"
      : choice.job.method.scale == 2 ? "half size, scaled up"
                                     : "quarter size, scaled up",
      choice.rmse, choice.pixels, choice.limit);
  return line.data();
}

}  // namespace hogelscope
