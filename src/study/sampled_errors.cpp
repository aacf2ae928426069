// SPDX-License-Identifier: BSD-3-Clause
#include "study/sampled_errors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

#include "core/base/random_numbers.h"
#include "core/engine/fast_simulation.h"
#include "core/engine/scaled_view.h"
#include "core/metrics/votes.h"

namespace hogelscope {

namespace {

constexpr std::array<int, 2> blockSize{32, 4};
constexpr std::array<int, 2> areaSize{64, 128};
constexpr double leastPixels = 256.0 * blockSize[0] * blockSize[1];
constexpr std::size_t mostGroups = 4096;  ///< of blocks of one view; more are joined in pairs
constexpr std::size_t mostDrawn = 2048;   ///< of all views, from which the bootstrap draws

/// Returns the blocks of an area in random order.
std::vector<PixelBlock> shuffledBlocks(const PixelBlock& area, RandomNumbers& random) {
  std::vector<PixelBlock> blocks;
  for (int y = area.y0; y < area.y1; y += blockSize[1])
    for (int x = area.x0; x < area.x1; x += blockSize[0])
      blocks.push_back(
          {x, y, std::min(x + blockSize[0], area.x1), std::min(y + blockSize[1], area.y1)});
  for (std::size_t k = blocks.size(); k > 1; --k)
    std::swap(blocks[k - 1], blocks[std::size_t(random.unit() * double(k))]);
  return blocks;
}

/// Joins neighbours, so that half as many are left.
void joinPairs(std::vector<double>& values) {
  std::size_t k = 0;
  for (; 2 * k < values.size(); ++k)
    values[k] = values[2 * k] + (2 * k + 1 < values.size() ? values[2 * k + 1] : 0);
  values.resize(k);
}

/// Adds blocks to groups of `merged` blocks.
void addGroups(std::vector<double>& groups, const std::vector<double>& blocks, int merged) {
  for (std::size_t k = 0; k < blocks.size(); k += std::size_t(merged)) {
    double sum = 0;
    for (std::size_t i = k; i < std::min(k + std::size_t(merged), blocks.size()); ++i)
      sum += blocks[i];
    groups.push_back(sum);
  }
}

}  // namespace

double pixelsOf(const RenderJob& job) {
  return double(job.state.camera.res[0]) * job.state.camera.res[1];
}

std::vector<std::vector<PixelBlock>> drawnBlocks(const std::array<int, 2>& res,
                                                 std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<std::vector<PixelBlock>> rounds(drawRounds);
  for (int y = 0; y < res[1]; y += areaSize[1])
    for (int x = 0; x < res[0]; x += areaSize[0]) {
      const std::vector<PixelBlock> blocks = shuffledBlocks(
          {x, y, std::min(x + areaSize[0], res[0]), std::min(y + areaSize[1], res[1])}, random);
      const double shift = rounds.front().empty() ? 0 : random.unit();
      for (std::size_t k = 0; k < blocks.size(); ++k) {
        const double place = (double(k) + shift) / double(blocks.size());  // below 1
        rounds[std::size_t(place * drawRounds)].push_back(blocks[k]);
      }
    }
  return rounds;
}

SampledErrors::SampledErrors(std::vector<NamedMethod> methods, std::vector<Question> questions,
                             double pixels, std::uint64_t seed, const ParallelRows& parallelRows,
                             Progress progress)
    : m_methods(std::move(methods)),
      m_questions(std::move(questions)),
      m_allPixels(pixels),
      m_seed(seed),
      m_rows(parallelRows),
      m_progress(std::move(progress)) {
  m_drawn = int(std::clamp(std::ceil(leastPixels * drawRounds / pixels), 1.0, double(drawRounds)));
}

void SampledErrors::add(const RenderJob& view) {
  View added{view, drawnBlocks(view.state.camera.res, m_seed + m_views.size()), {}, {}, 1};
  added.sums.assign(m_questions.size(), std::vector<Sums>(m_methods.size()));
  measure(added, 0, m_drawn);
  m_views.push_back(std::move(added));
}

void SampledErrors::draw(int rounds) {
  const int last = std::min(m_drawn + rounds, drawRounds);
  for (View& view : m_views) measure(view, m_drawn, last);
  m_drawn = last;
}

/// Measures rounds [first, last).
void SampledErrors::measure(View& view, int first, int last) {
  std::vector<PixelBlock> blocks;
  for (int round = first; round < last; ++round)
    std::ranges::copy(view.rounds[std::size_t(round)], std::back_inserter(blocks));
  if (blocks.empty()) return;
  std::vector<double> values(blocks.size());
  std::ranges::transform(blocks, values.begin(),
                         [](const PixelBlock& block) { return double(block.pixels()); });
  addGroups(view.pixels, values, view.merged);
  std::vector<Image> expected;
  for (const Question question : m_questions)
    expected.push_back(reference(question, view.job, blocks));
  for (std::size_t m = 0; m < m_methods.size(); ++m) {
    const Image image = picture(applyMethod(m_methods[m], view.job), blocks);
    for (std::size_t q = 0; q < m_questions.size(); ++q) {
      Sums& sums = view.sums[q][m];
      const auto width = std::size_t(image.width);
      for (std::size_t k = 0; k < blocks.size(); ++k) {
        const auto& [x0, y0, x1, y1] = blocks[k];
        int squares = 0;
        for (int y = y0; y < y1; ++y)
          for (std::size_t p = std::size_t(y) * width + std::size_t(x0),
                           end = p + std::size_t(x1 - x0);
               p < end; ++p) {
            for (std::size_t c = 3 * p; c < 3 * p + 3; ++c) {
              const int d = std::abs(int(image.rgb[c]) - int(expected[q].rgb[c]));
              squares += d * d;
              sums.largest = std::max(sums.largest, d);
            }
            sums.mismatches += image.seen[p] != expected[q].seen[p] ? 1 : 0;
          }
        values[k] = squares;
      }
      addGroups(sums.squares, values, view.merged);
    }
  }
  while (view.pixels.size() > mostGroups) {
    view.merged *= 2;
    joinPairs(view.pixels);
    for (std::vector<Sums>& ofQuestion : view.sums)
      for (Sums& sums : ofQuestion) joinPairs(sums.squares);
  }
}

/// Renders the blocks with the fast engine; all of a view that is scaled up, since its pixels
/// depend on others.
Image SampledErrors::picture(const RenderJob& job, const std::vector<PixelBlock>& blocks) {
  const int scale = job.method.scale;
  if (scale > 1) {
    const RenderJob small = reduced(job);
    const auto [width, height] = small.state.camera.res;
    const FastSimulation simulation(small, m_tables, m_rows, m_progress);
    Image image(width, height);
    m_rows(height, [&, width = width](int begin, int end) {
      const std::size_t first = std::size_t(begin) * std::size_t(width);
      simulation.rows(begin, end, 0, width, &image.rgb[3 * first], &image.seen[first]);
    });
    return enlarged(image, scale, job.state.camera.res);
  }
  const FastSimulation simulation(job, m_tables, m_rows, m_progress);
  Image image(job.state.camera.res[0], job.state.camera.res[1]);
  m_rows(int(blocks.size()), [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const auto& [x0, y0, x1, y1] = blocks[std::size_t(k)];
      for (int y = y0; y < y1; ++y) {
        const std::size_t at = std::size_t(y) * std::size_t(image.width) + std::size_t(x0);
        simulation.rows(y, y + 1, x0, x1, &image.rgb[3 * at], &image.seen[at]);
      }
    }
  });
  return image;
}

Image SampledErrors::reference(Question question, const RenderJob& job,
                               const std::vector<PixelBlock>& blocks) {
  const bool hasPupil = !plan(job).aperture.isPinhole;
  NamedMethod method = question == Question::displayAsBuilt
                           ? NamedMethod{"display"}
                           : NamedMethod{"ideal", Reconstruction::quadrilinear, 8};
  if (hasPupil) method.pupilSamples = Aperture::mostSamples;
  const RenderJob used = applyMethod(method, job);
  if (question == Question::idealPicture || hasPupil) return picture(used, blocks);
  const Simulation simulation(used);
  Image image(job.state.camera.res[0], job.state.camera.res[1]);
  const Progress heard = forThreads(m_progress);
  m_rows(int(blocks.size()), [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      throwIfCancelled(heard);
      const auto& [x0, y0, x1, y1] = blocks[std::size_t(k)];
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) simulation.render(x, y, image);
    }
  });
  return image;
}

bool SampledErrors::areFew() const {
  return pixels() < leastPixels;
}

double SampledErrors::pixels() const {
  double sum = 0;
  for (const View& view : m_views)
    for (const double pixels : view.pixels) sum += pixels;
  return sum;
}

/// Returns sums over groups of blocks: of the values, then of the squares of each method. Views
/// count by their pixels, of which each view has the same share but for rounding.
std::vector<std::vector<double>> SampledErrors::groupsOf(std::size_t question) const {
  std::size_t count = 0;
  for (const View& view : m_views) count += view.pixels.size();
  const bool isOfViews = pixelsOfViews() < m_allPixels;
  const int joined = isOfViews ? int(count) : int((count + mostDrawn - 1) / mostDrawn);
  std::vector<std::vector<double>> groups;
  for (const View& view : m_views) {
    const double drawn = std::accumulate(view.pixels.begin(), view.pixels.end(), 0.0);
    const double weight = pixelsOf(view.job) / drawn;
    const std::size_t first = groups.size();
    const auto addColumn = [&](const std::vector<double>& sums, double factor) {
      std::vector<double> column;
      addGroups(column, sums, joined);
      groups.resize(first + column.size());
      for (std::size_t k = 0; k < column.size(); ++k)
        groups[first + k].push_back(factor * column[k]);
    };
    addColumn(view.pixels, 3 * weight);
    for (const Sums& sums : view.sums[question]) addColumn(sums.squares, weight);
  }
  return groups;
}

bool SampledErrors::areKnown(double decibels) const {
  for (std::size_t q = 0; q < m_questions.size(); ++q) {
    std::vector<double> squares(m_methods.size());
    for (const View& view : m_views)
      for (std::size_t m = 0; m < m_methods.size(); ++m)
        squares[m] = std::max(squares[m], *std::ranges::max_element(view.sums[q][m].squares));
    if (std::ranges::find(squares, 0.0) != squares.end()) return false;
  }
  return std::ranges::all_of(m_questions, [&](Question question) {
    return std::ranges::all_of(errors(question), [&](const MethodError& error) {
      return error.low > 0 && 10 * std::log10(error.high / error.low) < decibels;
    });
  });
}

double SampledErrors::pixelsOfViews() const {
  double sum = 0;
  for (const View& view : m_views) sum += pixelsOf(view.job);
  return sum;
}

std::vector<MethodError> SampledErrors::errors(Question question) const {
  const auto q = std::size_t(std::ranges::find(m_questions, question) - m_questions.begin());
  const std::vector<std::vector<double>> groups = groupsOf(q);
  const auto meansOf = [](const std::vector<double>& sums) {
    std::vector<double> means;
    for (std::size_t m = 1; m < sums.size(); ++m) means.push_back(sums[m] / sums.front());
    return means;
  };
  std::vector<double> totals(m_methods.size() + 1);
  for (const std::vector<double>& group : groups)
    std::ranges::transform(group, totals, totals.begin(), std::plus<>());
  const std::vector<double> means = meansOf(totals);
  const double drawn = pixels();
  std::vector<MethodError> errors(m_methods.size());
  for (std::size_t m = 0; m < errors.size(); ++m) {
    errors[m].square = errors[m].low = errors[m].high = means[m];
    for (const View& view : m_views) {
      errors[m].largest = std::max(errors[m].largest, view.sums[q][m].largest);
      errors[m].mismatches += view.sums[q][m].mismatches / drawn;
    }
  }
  if (drawn < m_allPixels) setIntervals(errors, groups, meansOf);
  return errors;
}

namespace {

/// Returns a quantile of χ² by Wilson and Hilferty (1931), `z` that of the normal distribution.
double chiSquare(double freedom, double z) {
  const double part = 2 / (9 * freedom);
  return freedom * std::pow(std::max(1 - part + z * std::sqrt(part), 0.0), 3);
}

/// Returns the 95 % interval of a sum of few events of different sizes: that of a gamma
/// distribution of its mean and variance, whose upper end has one event more of the largest size
/// (Fay and Feuer 1997). The bootstrap knows nothing of events that were not met. `z` is Student's
/// quantile, since the variance is known from few groups.
Interval intervalOfEvents(double sum, double variance, double largest, double z) {
  Interval interval;
  if (sum > 0 && variance > 0)
    interval.low = variance / (2 * sum) * chiSquare(2 * sum * sum / variance, -z);
  else
    interval.low = sum;
  const double more = sum + largest;
  const double spread = variance + largest * largest;
  interval.high = spread > 0 ? spread / (2 * more) * chiSquare(2 * more * more / spread, z) : sum;
  return interval;
}

}  // namespace

void SampledErrors::setIntervals(std::vector<MethodError>& errors,
                                 const std::vector<std::vector<double>>& groups,
                                 const FiguresOfSums& meansOf) const {
  constexpr std::size_t leastGroups = 2;
  constexpr double largestSquare = 255.0 * 255;
  if (groups.size() < leastGroups) {
    for (MethodError& error : errors) error.low = 0, error.high = largestSquare;
    return;
  }
  double values = 0;
  for (const std::vector<double>& group : groups) values += group.front();
  std::vector<double> variances(errors.size());  // of the means
  std::vector<double> largest(errors.size());    // parts of a group of the means
  for (const std::vector<double>& group : groups)
    for (std::size_t m = 0; m < errors.size(); ++m) {
      const double part = group[m + 1] / values;
      variances[m] += std::pow(part - errors[m].square * group.front() / values, 2);
      largest[m] = std::max(largest[m], part);
    }
  const double largestOfAll = *std::ranges::max_element(largest);
  const double known = pixelsOfViews() < m_allPixels ? pixelsOfViews() : pixels();
  const double unknown = 1 - known / m_allPixels;
  const double narrowed = std::sqrt(unknown);
  const std::vector<Interval> intervals =
      bootstrap(groups, meansOf, {.resamples = resamplesFor(groups.size())});
  for (std::size_t m = 0; m < errors.size(); ++m) {
    double unmet = largest[m] > 0 ? largest[m] : largestOfAll;
    if (unmet == 0) unmet = largestSquare / double(groups.size());
    const double square = errors[m].square;
    const auto count = double(groups.size());
    const Interval events =
        intervalOfEvents(square, unknown * variances[m] * count / (count - 1), unknown * unmet,
                         studentQuantile(int(groups.size()) - 1));
    errors[m].low = std::min(square - narrowed * (square - intervals[m].low), events.low);
    errors[m].high = std::max(square + narrowed * (intervals[m].high - square), events.high);
    errors[m].high = std::min(errors[m].high, largestSquare);
  }
}

}  // namespace hogelscope
