// SPDX-License-Identifier: BSD-3-Clause
// Finds the borders of hogels, and the period of views in an image of tiles.
#include "capture/order/picture_grids.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace hogelscope {

namespace {

float greyOf(const float* rgb) {
  return 0.299F * rgb[0] + 0.587F * rgb[1] + 0.114F * rgb[2];
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
/// errors of values whose deviation is 1. Multiples of the hogels' period have fewer values there,
/// and divisors include others.
double standOut(const std::vector<double>& values, std::size_t period) {
  double at = 0, others = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool isBorder = k % period == period - 1;
    (isBorder ? at : others) += values[k];
    count += std::size_t(isBorder);
  }
  const double n = double(count), m = double(values.size() - count);
  return (at / n - others / m) / std::sqrt(1 / n + 1 / m);
}

constexpr std::size_t mostTiles = 32;
constexpr std::size_t leastTile = 24;  // pixels of a tile

/// One axis of the image: the sums of the differences of neighbours along it, and lines of grey
/// values, evenly spread over the other axis.
class Axis {
 public:
  Axis(std::size_t length, std::size_t across) : m_length(length), m_differences(length - 1) {
    constexpr std::size_t most = 200;
    constexpr std::size_t mostValues = 4000000;
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

  /// Adds the difference between the values at `at` and `at` + 1.
  void addDifference(std::size_t at, double difference) { m_differences[at] += difference; }
  /// Reduces the differences once all are added, so that a few strong edges of the content count
  /// little.
  void finish() {
    const double mean = meanOf(m_differences);
    for (double& value : m_differences) value = mean > 0 ? std::log1p(value / mean) : 0;
    m_deviation = deviationOf(m_differences);
  }
  /// Returns how far each `times`-th border of a period stands out against its other borders, in
  /// standard errors.
  [[nodiscard]] double standOut(std::size_t period, std::size_t times) const {
    std::vector<double> borders;
    for (std::size_t k = period - 1; k < m_differences.size(); k += period)
      borders.push_back(m_differences[k]);
    const double deviation = deviationOf(borders);
    const bool isEnough = borders.size() >= 2 * times && deviation > 0;
    return isEnough ? hogelscope::standOut(borders, times) / deviation : 0;
  }
  /// Returns how far the borders of a period stand out, in standard errors.
  [[nodiscard]] double standOut(std::size_t period) const {
    return m_deviation > 0 ? hogelscope::standOut(m_differences, period) / m_deviation : 0;
  }

  /// Returns how far the borders of a period stand out that are none of a multiple of it, in
  /// standard errors.
  [[nodiscard]] double standOutBeside(std::size_t period, std::size_t multiple) const {
    std::vector<double> values, borders;
    for (std::size_t k = 0; k < m_differences.size(); ++k)
      if (k % multiple != multiple - 1)
        (k % period == period - 1 ? borders : values).push_back(m_differences[k]);
    if (borders.empty() || values.empty() || !(m_deviation > 0)) return 0;
    return (meanOf(borders) - meanOf(values)) / m_deviation /
           std::sqrt(1 / double(borders.size()) + 1 / double(values.size()));
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

  /// Returns the mean difference of values that are `shift` apart in two neighbouring periods,
  /// divided by that of values in one period.
  [[nodiscard]] double crossing(std::size_t period, std::size_t shift) const {
    double within = 0, across = 0;
    for (std::size_t line = 0; line < m_values.size(); line += m_length) {
      const float* const values = m_values.data() + line;
      for (std::size_t begin = 0; begin + period <= m_length; begin += period) {
        float one = 0, two = 0;
        const std::size_t end = std::min(begin + period, m_length - shift);
        for (std::size_t k = begin; k < end; ++k)
          (k + shift < begin + period ? one : two) += std::abs(values[k + shift] - values[k]);
        within += double(one);
        across += double(two);
      }
    }
    const double ofOne = double(m_length / period * (period - shift));
    const double ofTwo = double((m_length / period - 1) * shift);
    return within > 0 ? across / ofTwo / (within / ofOne) : across > 0 ? infinite : 1;
  }
  static constexpr double infinite = std::numeric_limits<double>::infinity();

 private:
  std::size_t m_length;
  std::vector<double> m_differences;
  double m_deviation = 0;
  std::size_t m_step = 1;
  std::vector<float> m_values;
};

/// The period of borders along an axis.
struct Borders {
  std::size_t period = 0;
  double standOut = 0;
  bool isDistinct = false;    ///< HogelGrid::isDistinct
  bool isContinuous = false;  ///< values far apart do not depend on the borders between them
  /// Whether a codec's blocks of 8 or 16 pixels, or of other sizes once the picture has been
  /// scaled, or enlarged pixels have such borders.
  [[nodiscard]] bool areOfBlocks() const {
    constexpr std::size_t scaled = 4;
    return !isDistinct && isContinuous && (period % scaled == 0 || period < scaled);
  }
  /// Values within a period are nearly the same, as in a block of a strongly compressed JPEG.
  [[nodiscard]] bool isFlat() const { return !isDistinct && !isContinuous; }
};

/// Returns how the values of neighbouring periods differ. At a border a codec's blocks differ from
/// their neighbours too, but values half a block apart and more hardly know of it.
Borders bordersOf(const Axis& axis, std::size_t period, double standOut) {
  constexpr double clear = 1.25;
  Borders borders{period, standOut, false, true};
  for (const std::size_t shift : {period / 2, 3 * period / 4, period - 1}) {
    if (shift == 0) continue;
    const double ratio = axis.crossing(period, shift);
    if (ratio < 1 / clear || ratio > clear) borders.isContinuous = false;
    if (ratio < 1 / clear) borders.isDistinct = true;
  }
  constexpr std::size_t wide = 12;  // a smaller block's border reaches as far as a quarter of it
  constexpr double clearNear = 1.6;
  if (period >= wide && axis.crossing(period, period / 4) > clearNear) borders.isContinuous = false;
  // Pixels that are repeated, as where a picture has been enlarged, are no directions.
  if (axis.crossing(period, 1) == Axis::infinite) borders.isContinuous = true;
  return borders;
}

/// Whether every second, or every third, border of a codec's period stands out against the others:
/// then these are the codec's. Those of another period may fall together with the codec's.
bool areOfLongerPeriod(const Axis& axis, std::size_t period) {
  constexpr double clear = 5;  // standard errors
  constexpr std::size_t block = 8;
  if (period % block != 0) return false;
  const auto isLonger = [&](std::size_t times) {
    return axis.length() % (times * period) == 0 && axis.standOut(period, times) > clear;
  };
  return isLonger(2) || isLonger(3);
}

/// Returns the periods whose borders stand out, the clearest ones first, those that a codec's
/// blocks may have last.
std::vector<Borders> allBorders(const Axis& axis, const Progress& progress) {
  constexpr double least = 4;  // standard errors
  std::vector<Borders> found;
  for (std::size_t period = 2; period <= axis.length() / 2; ++period)
    if (axis.length() % period == 0 && axis.standOut(period) > least)
      found.push_back({period, axis.standOut(period)});
  std::ranges::sort(found, std::greater<>(), &Borders::standOut);
  constexpr std::size_t most = 8;
  found.resize(std::min(most, found.size()));
  for (Borders& borders : found) {
    throwIfCancelled(progress);
    borders = bordersOf(axis, borders.period, borders.standOut);
  }
  std::erase_if(found, [&](const Borders& each) { return areOfLongerPeriod(axis, each.period); });
  std::stable_partition(found.begin(), found.end(),
                        [](const Borders& each) { return !each.areOfBlocks(); });
  return found;
}

/// Returns the fraction by which values differ less about one period apart than a quarter of it
/// less or more. Content moves from tile to tile, by an eighth of a tile at most.
double likeness(const Axis& axis, std::size_t period) {
  const std::size_t off = std::max<std::size_t>(2, period / 4);
  const std::size_t reach = std::max<std::size_t>(1, period / 8);
  const std::size_t step = std::max<std::size_t>(1, reach / 4);
  double least = axis.difference(period);
  for (std::size_t by = step; by <= reach; by += step)
    least = std::min({least, axis.difference(period - by), axis.difference(period + by)});
  const double beside = std::min(axis.difference(period - off), axis.difference(period + off));
  return beside > 0 ? 1 - least / beside : 0;
}

/// The tiles along an axis; none if their likeness is 0.
struct Tiles {
  std::size_t count = 0;
  double likeness = 0;
};

/// Returns the tiles along an axis. Multiples of the period are periods too, and a neighbouring
/// divisor of the length is alike where content moves: of the periods that are half as clear as the
/// clearest the one counts whose borders stand out most, or the shortest of the clear ones if none
/// does. A period of hogels is too short for a view.
Tiles tilesAlong(const Axis& axis, const Progress& progress) {
  constexpr double least = 0.2;
  constexpr double half = 0.5;  // of the clearest
  constexpr std::size_t leastPeriod = 8;
  std::vector<std::pair<std::size_t, double>> periods;
  double clearest = least;
  for (std::size_t period = leastPeriod; period <= axis.length() / 2; ++period) {
    if (axis.length() % period != 0) continue;
    reportProgress(progress, double(period) / double(axis.length() / 2));
    periods.emplace_back(period, likeness(axis, period));
    clearest = std::max(clearest, periods.back().second);
  }
  std::erase_if(periods, [&](const auto& each) { return each.second < half * clearest; });
  if (periods.empty()) return {};
  // Multiples of a period are no more alike than itself.
  constexpr double nearly = 0.9;
  auto found = *std::ranges::find_if(
      periods, [&](const auto& each) { return each.second >= nearly * clearest; });
  constexpr double visible = 4;  // standard errors
  double most = visible;
  for (const auto& each : periods)
    if (const double height = axis.standOut(each.first); height > most) most = height, found = each;
  // Borders that fall together with those of a codec's blocks stand out more than the others. Tiles
  // that are no less alike than two of them together need less of a border between them.
  const auto isShorter = [&](const auto& each) {
    if (found.first % each.first != 0 || each.first == found.first) return false;
    const double between = axis.standOutBeside(each.first, found.first);
    return each.second >= found.second ? between > 1
                                       : each.second >= nearly * found.second && between > most / 2;
  };
  if (const auto shorter = std::ranges::find_if(periods, isShorter);
      most > visible && shorter != periods.end())
    found = *shorter;
  const std::size_t count = axis.length() / found.first;
  if (found.second < least || found.first < leastTile || count > mostTiles) return {};
  return {count, found.second};
}

void readAxes(const PictureRows& picture, Axis& across, Axis& down, const Progress& progress) {
  const std::size_t width = picture.width;
  std::vector<float> above, row(width);
  picture.read(
      [&](std::size_t y, const float* rgb) {
        for (std::size_t x = 0; x < width; ++x, rgb += 3) row[x] = greyOf(rgb);
        for (std::size_t x = 0; x + 1 < width; ++x)
          across.addDifference(x, double(std::abs(row[x + 1] - row[x])));
        for (std::size_t x = 0; x < width && !above.empty(); ++x)
          down.addDifference(y - 1, double(std::abs(row[x] - above[x])));
        for (std::size_t x = 0; x < width; x += down.step()) down.set(x, y, row[x]);
        if (y % across.step() == 0)
          for (std::size_t x = 0; x < width; ++x) across.set(y, x, row[x]);
        above = row;
      },
      progress);
  across.finish();
  down.finish();
}

/// Whether the means of tiles have values at equal distances, as those of the blocks of a strongly
/// compressed JPEG, which codes their means in steps.
bool areSteps(const std::vector<double>& means) {
  constexpr double least = 2.0 / 255, most = 40.0 / 255, next = 1.005;
  const auto count = double(means.size());
  // 1: all means lie at such distances; the sum of n evenly spread ones is about √n.
  const double clear = std::max(0.15, 5 / std::sqrt(count));
  const double deviation = deviationOf(means);
  for (double step = least; step < most && step < 2 * deviation; step *= next) {
    std::complex<double> sum = 0;
    for (const double mean : means) sum += std::polar(1.0, 2 * std::numbers::pi * mean / step);
    if (std::abs(sum) > clear * count) return true;
  }
  return false;
}

/// Whether the hogels of a grid are the blocks of a strongly compressed JPEG.
bool areJpegBlocks(const PictureRows& picture, const Borders& across, const Borders& down,
                   const Progress& progress) {
  const std::size_t columns = picture.width / across.period;
  constexpr std::size_t most = 20000;  // blocks
  std::vector<double> means(std::min(most / columns + 1, picture.height / down.period) * columns);
  const std::size_t rows = means.size() / columns * down.period;
  picture.read(
      [&](std::size_t y, const float* rgb) {
        for (std::size_t x = 0; x < picture.width && y < rows; ++x)
          means[y / down.period * columns + x / across.period] += double(greyOf(rgb + 3 * x));
      },
      progress);
  for (double& mean : means) mean /= double(across.period * down.period);
  return areSteps(means);
}

/// Returns the hogels with the clearest borders along both axes. A hogel has about as many
/// directions down as across; one of 8×512 is content with lines.
std::optional<HogelGrid> hogelsOf(const PictureRows& picture, const std::vector<Borders>& across,
                                  const std::vector<Borders>& down, const Progress& progress) {
  constexpr std::size_t mostLonger = 10, ofEnlarged = 4;
  for (const Borders& x : across)
    for (const Borders& y : down) {
      if (std::max(x.period, y.period) > mostLonger * std::min(x.period, y.period)) continue;
      // Blocks have borders along both axes.
      if ((x.areOfBlocks() && !y.isDistinct) || (y.areOfBlocks() && !x.isDistinct)) continue;
      if (x.isFlat() && y.isFlat() && areJpegBlocks(picture, x, y, progress)) return std::nullopt;
      return HogelGrid{
          {int(picture.width / x.period), int(picture.height / y.period)},
          {int(x.period), int(y.period)},
          std::min(x.standOut, y.standOut),
          (x.isDistinct && !y.isContinuous) || (y.isDistinct && !x.isContinuous),
          !x.isDistinct && !y.isDistinct &&
              (x.isContinuous || y.isContinuous || std::max(x.period, y.period) <= ofEnlarged)};
    }
  return std::nullopt;
}

}  // namespace

PictureGrids findPictureGrids(const PictureRows& picture, const Progress& progress) {
  PictureGrids grids;
  if (picture.width < 4 || picture.height < 4) return grids;
  Axis across(picture.width, picture.height), down(picture.height, picture.width);
  readAxes(picture, across, down, part(progress, 0, 0.6));
  grids.hogels = hogelsOf(picture, allBorders(across, progress), allBorders(down, progress),
                          part(progress, 0.6, 0.7));
  const Tiles columns = tilesAlong(across, part(progress, 0.7, 0.8));
  if (columns.count == 0) return grids;
  const Tiles rows = tilesAlong(down, part(progress, 0.8, 1));
  if (rows.count > 0)
    grids.tiles =
        TileGrid{{int(columns.count), int(rows.count)}, std::min(columns.likeness, rows.likeness)};
  return grids;
}

}  // namespace hogelscope
