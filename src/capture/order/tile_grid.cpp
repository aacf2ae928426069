// SPDX-License-Identifier: BSD-3-Clause
// Finds the period of views in an image of tiles.
#include <algorithm>
#include <cmath>
#include <vector>

#include "capture/order/picture_grids.h"

namespace hogelscope {

namespace {

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

std::optional<std::array<int, 2>> findTileGrid(const PictureRows& picture,
                                               const Progress& progress) {
  const auto& [width, height, read] = picture;
  constexpr double mostPixels = 3e8;  // a few seconds
  if (std::min(width, height) < 2 * leastTile || double(width) * double(height) > mostPixels)
    return std::nullopt;
  Lines rows(width, height), columns(height, width);
  read(
      [&, width = width](std::size_t y, const float* rgb) {
        const auto grey = [rgb](std::size_t x) {
          return rgb[3 * x] + rgb[3 * x + 1] + rgb[3 * x + 2];
        };
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
