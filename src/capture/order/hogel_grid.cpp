// SPDX-License-Identifier: BSD-3-Clause
// Finds the borders of hogels.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "capture/order/picture_grids.h"

namespace hogelscope {

namespace {

/// Sums of the differences of neighbours, between columns and between rows.
struct Differences {
  std::vector<double> columns;
  std::vector<double> rows;
};

float greyOf(const float* rgb) {
  return rgb[0] + rgb[1] + rgb[2];
}

Differences differencesOf(const PictureRows& picture, const Progress& progress) {
  const std::size_t width = picture.width;
  Differences sums{std::vector<double>(width - 1), std::vector<double>(picture.height - 1)};
  std::vector<float> above, row(width);
  picture.read(
      [&](std::size_t y, const float* rgb) {
        for (std::size_t x = 0; x < width; ++x, rgb += 3) row[x] = greyOf(rgb);
        for (std::size_t x = 0; x + 1 < width; ++x)
          sums.columns[x] += double(std::abs(row[x + 1] - row[x]));
        for (std::size_t x = 0; x < width && !above.empty(); ++x)
          sums.rows[y - 1] += double(std::abs(row[x] - above[x]));
        above = row;
      },
      progress);
  return sums;
}

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double deviationOf(const std::vector<double>& values) {
  const double mean = meanOf(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / double(values.size()));
}

/// Returns how far the mean of the values at k ≡ period - 1 exceeds that of the others, in standard
/// errors. Multiples of the hogels' period have fewer values there, and divisors include others.
double standOut(const std::vector<double>& values, std::size_t period) {
  double at = 0, others = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool isBorder = k % period == period - 1;
    (isBorder ? at : others) += values[k];
    count += std::size_t(isBorder);
  }
  const double n = double(count), m = double(values.size() - count);
  return (at / n - others / m) / (deviationOf(values) * std::sqrt(1 / n + 1 / m));
}

/// Subtracts the mean of every eighth value, because JPEG's blocks of 8 pixels have borders too.
std::vector<double> withoutBlocks(std::vector<double> values) {
  constexpr std::size_t block = 8;
  for (std::size_t phase = 0; phase < std::min(block, values.size()); ++phase) {
    double sum = 0, count = 0;
    for (std::size_t k = phase; k < values.size(); k += block) sum += values[k], ++count;
    for (std::size_t k = phase; k < values.size(); k += block) values[k] -= sum / count;
  }
  return values;
}

/// The period of borders, and how far they stand out.
struct Tile {
  std::size_t period = 0;
  double standOut = 0;
};

/// Returns the period whose borders stand out most, preferably one that stands out without JPEG's
/// blocks too; a period of 0 if there is none.
Tile tileOf(const std::vector<double>& differences) {
  const double mean = meanOf(differences);
  if (!(mean > 0)) return {};
  std::vector<double> logs;  // so that a few strong edges of the content count little
  logs.reserve(differences.size());
  for (const double value : differences) logs.push_back(std::log1p(value / mean));
  const std::vector<double> rest = withoutBlocks(logs);
  const std::size_t length = logs.size() + 1;
  constexpr double least = 4;  // standard errors
  double best = 0, bestOfAll = least;
  std::size_t found = 0, foundOfAll = 0;
  for (std::size_t period = 2; period <= length / 2; ++period) {
    if (length % period != 0) continue;
    const double height = standOut(logs, period);
    if (height > bestOfAll) bestOfAll = height, foundOfAll = period;
    if (height > best && standOut(rest, period) > least) best = height, found = period;
  }
  // For hogels of 8 directions only noise remains without the blocks.
  constexpr double share = 0.6;
  return best > share * bestOfAll ? Tile{found, best} : Tile{foundOfAll, bestOfAll};
}

}  // namespace

std::optional<HogelGrid> findHogelGrid(const PictureRows& picture, const Progress& progress) {
  if (picture.width < 4 || picture.height < 4) return std::nullopt;
  const Differences differences = differencesOf(picture, progress);
  const Tile across = tileOf(differences.columns), down = tileOf(differences.rows);
  if (across.period == 0 || down.period == 0) return std::nullopt;
  return HogelGrid{{int(picture.width / across.period), int(picture.height / down.period)},
                   {int(across.period), int(down.period)},
                   std::min(across.standOut, down.standOut)};
}

}  // namespace hogelscope
