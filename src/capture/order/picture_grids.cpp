// SPDX-License-Identifier: BSD-3-Clause
// Finds the borders of hogels, and the period of views in an image of tiles.
#include "capture/order/picture_grids.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

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

constexpr int mostTiles = 20;
constexpr std::size_t leastTile = 100;  // pixels of a tile

/// Lines of grey values along an axis, evenly spread over the other one.
class Lines {
 public:
  Lines(std::size_t length, std::size_t across) : m_length(length) {
    constexpr std::size_t most = 200;
    constexpr std::size_t mostValues = 20000000;
    const std::size_t count = std::clamp<std::size_t>(mostValues / length, 1, most);
    m_step = (across + count - 1) / count;
    m_values.resize((across + m_step - 1) / m_step * length);
  }

  [[nodiscard]] std::size_t length() const { return m_length; }
  [[nodiscard]] std::size_t step() const { return m_step; }
  /// Sets a value of the line at a multiple of step().
  void set(std::size_t line, std::size_t at, float grey) {
    m_values[line / m_step * m_length + at] = grey;
  }

  /// Returns the mean difference of values that are `shift` apart.
  [[nodiscard]] double difference(std::size_t shift) const {
    double sum = 0;
    for (std::size_t line = 0; line < m_values.size(); line += m_length) {
      const float* const values = m_values.data() + line;
      float ofLine = 0;
      for (std::size_t k = shift; k < m_length; ++k)
        ofLine += std::abs(values[k] - values[k - shift]);
      sum += double(ofLine);
    }
    return sum / double(m_values.size() / m_length) / double(m_length - shift);
  }

 private:
  std::size_t m_length;
  std::size_t m_step = 1;
  std::vector<float> m_values;
};

/// Returns the fraction by which values differ less at a shift of one period than at slightly
/// smaller and larger shifts.
double likeness(const Lines& lines, std::size_t period) {
  const std::size_t off = std::max<std::size_t>(1, period / 8);
  const double beside = std::min(lines.difference(period - off), lines.difference(period + off));
  return beside > 0 ? 1 - lines.difference(period) / beside : 0;
}

/// Returns the number of tiles along the lines, or 0. Multiples of the period are periods too, so
/// the shortest of the clear ones counts; that of hogels is too short for a view.
int tilesAlong(const Lines& lines, const Progress& progress) {
  constexpr double least = 0.3;
  constexpr double clear = 0.8;  // of the clearest
  constexpr std::size_t leastPeriod = 4;
  std::vector<std::pair<std::size_t, double>> periods;
  double clearest = least;
  for (std::size_t period = leastPeriod; period <= lines.length() / 2; ++period) {
    if (lines.length() % period != 0) continue;
    reportProgress(progress, double(period) / double(lines.length() / 2));
    periods.emplace_back(period, likeness(lines, period));
    clearest = std::max(clearest, periods.back().second);
  }
  const auto found = std::ranges::find_if(
      periods, [&](const auto& each) { return each.second >= clear * clearest; });
  if (found == periods.end() || found->second < least || found->first < leastTile) return 0;
  const std::size_t count = lines.length() / found->first;
  return count <= mostTiles ? int(count) : 0;
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

std::optional<std::array<int, 2>> findTileGrid(const PictureRows& picture,
                                               const Progress& progress) {
  const auto& [width, height, read] = picture;
  constexpr double mostPixels = 3e8;  // a few seconds
  if (std::min(width, height) < 2 * leastTile || double(width) * double(height) > mostPixels)
    return std::nullopt;
  Lines rows(width, height), columns(height, width);
  read(
      [&, width = width](std::size_t y, const float* rgb) {
        const auto grey = [rgb](std::size_t x) { return greyOf(rgb + 3 * x); };
        for (std::size_t x = 0; x < width; x += columns.step()) columns.set(x, y, grey(x));
        if (y % rows.step() != 0) return;
        for (std::size_t x = 0; x < width; ++x) rows.set(y, x, grey(x));
      },
      part(progress, 0, 0.6));
  const int across = tilesAlong(rows, part(progress, 0.6, 0.8));
  const int down = across > 0 ? tilesAlong(columns, part(progress, 0.8, 1)) : 0;
  if (down == 0) return std::nullopt;
  return std::array{across, down};
}

}  // namespace hogelscope
