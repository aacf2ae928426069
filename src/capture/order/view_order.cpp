// SPDX-License-Identifier: BSD-3-Clause
#include "capture/order/view_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "capture/order/view_motion.h"

namespace hogelscope {

namespace {

/// A view of the grid whose neighbours are examined.
struct Centre {
  int row;
  int column;
};

/// The views, scaled to a size for the flow, each fetched once.
class Views {
 public:
  explicit Views(const GreyGrid& grid) : m_grid(grid) {}

  cv::Mat1b at(int row, int column) {
    const auto [known, isNew] = m_views.try_emplace({row, column});
    if (isNew) known->second = scaled(m_grid.view(row, column));
    return known->second;
  }
  DenseMotion motion(const cv::Mat1b& from, const cv::Mat1b& to) {
    return m_finder.between(from, to);
  }
  /// Returns the scale: pixels here per pixel of the original images.
  [[nodiscard]] double scale() const { return m_scale; }

 private:
  cv::Mat1b scaled(const GreyPicture& picture) {
    constexpr double mostSide = 512;
    constexpr double leastSide = 160;
    const double side = std::max({picture.width, picture.height, 1});
    if (side > mostSide) m_scale = mostSide / side;
    if (side < leastSide) m_scale = std::ceil(leastSide / side);
    const cv::Mat1b whole(picture.height, picture.width,
                          const_cast<std::uint8_t*>(picture.values.data()));
    cv::Mat1b result;
    const cv::Size size(std::max(1, cvRound(picture.width * m_scale)),
                        std::max(1, cvRound(picture.height * m_scale)));
    cv::resize(whole, result, size, 0, 0, m_scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    return result;
  }

  const GreyGrid& m_grid;
  std::map<std::pair<int, int>, cv::Mat1b> m_views;
  MotionFinder m_finder;
  double m_scale = 1;
};

double percentile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  const auto at = values.begin() + std::ptrdiff_t(part * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The repetitions() of a view along x and y.
using Repetitions = std::array<cv::Mat1b, 2>;

/// One direction of the grid: along its columns (within a row) or along its rows.
class Direction {
 public:
  Direction(Views& views, const GreyGrid& grid, bool isAlongColumns)
      : m_views(views),
        m_grid(grid),
        m_isAlongColumns(isAlongColumns),
        m_count(isAlongColumns ? grid.columns : grid.rows) {}

  [[nodiscard]] bool hasNeighbours() const { return m_count > 1; }

  Neighbours neighbours(const Centre& centre, int step) {
    Neighbours result{m_views.at(centre.row, centre.column), step, {}, {}};
    if (has(centre, -step)) result.before = m_views.motion(result.view, other(centre, -step));
    if (has(centre, step)) result.after = m_views.motion(result.view, other(centre, step));
    return result;
  }

  /// Returns the neighbours at a step at which content moves by about a pixel, if views are that
  /// far apart.
  Neighbours neighboursThatMove(const Centre& centre, const Progress& progress) {
    constexpr double leastMotion = 0.8;  // pixels
    const int before = reach(centre, -1), after = reach(centre, 1);
    const int most =
        std::max(1, before > 0 && after > 0 ? std::min(before, after) : std::max(before, after));
    for (m_step = 1;; m_step = std::min(2 * m_step, most)) {
      throwIfCancelled(progress);
      Neighbours result = neighbours(centre, m_step);
      const DenseMotion motion = motionPerView(result);
      std::vector<double> lengths;
      for (int y = 0; y < motion.shift.rows; y += 4)
        for (int x = 0; x < motion.shift.cols; x += 4)
          if (motion.isSure(y, x) != 0) lengths.push_back(cv::norm(motion.shift(y, x)));
      constexpr double mostRest = 0.8;
      if (m_step == most || percentile(lengths, mostRest) * m_step > leastMotion) return result;
    }
  }
  [[nodiscard]] int step() const { return m_step; }

  Occlusions occlusions(const Centre& centre, const Neighbours& around, const Repetitions& repeats,
                        int axis) {
    return occlusionsIn(around, repeats[std::size_t(axis)], axis, reach(centre, -1),
                        reach(centre, 1), [&](int t) { return other(centre, t); });
  }

 private:
  [[nodiscard]] bool has(const Centre& centre, int by) const {
    return m_isAlongColumns ? m_grid.has(centre.row, centre.column + by)
                            : m_grid.has(centre.row + by, centre.column);
  }
  /// Returns the number of consecutive views that way.
  [[nodiscard]] int reach(const Centre& centre, int way) const {
    int steps = 0;
    while (has(centre, way * (steps + 1))) ++steps;
    return steps;
  }
  cv::Mat1b other(const Centre& centre, int by) {
    return m_isAlongColumns ? m_views.at(centre.row, centre.column + by)
                            : m_views.at(centre.row + by, centre.column);
  }

  Views& m_views;
  const GreyGrid& m_grid;
  bool m_isAlongColumns;
  int m_count;
  int m_step = 1;
};

/// Returns the motions of squares of pixels that have structure in all directions.
std::vector<PlaceMotion> placesOf(const cv::Mat1b& view, const Repetitions& repetitions,
                                  const DenseMotion& alongColumns, const DenseMotion& alongRows) {
  constexpr int side = 16;          // pixels of a square
  constexpr int leastPixels = 24;   // in a square
  constexpr float leastCorner = 4;  // (code values per pixel)²; noise of two has less
  cv::Mat1f picture;
  view.convertTo(picture, CV_32F);
  cv::Mat1f corner;
  constexpr int sobel = 3;
  constexpr double perPixel = 1.0 / 4;  // OpenCV's gain: 49 pixels of (8 slopes / 28)²
  cv::cornerMinEigenVal(picture, corner, 7, sobel);
  corner *= perPixel;
  // A grid needs x and y; one row or column needs the one along which it moves.
  const auto& [repeatsX, repeatsY] = repetitions;
  const bool isGrid = !alongColumns.shift.empty() && !alongRows.shift.empty();
  const cv::Mat1b repeats = isGrid ? repeatsX | repeatsY : repeatsX & repeatsY;
  corner.setTo(0, repeats);
  std::vector<PlaceMotion> places;
  for (int top = 0; top + side <= view.rows; top += side)
    for (int left = 0; left + side <= view.cols; left += side) {
      std::array<std::vector<double>, 4> values;
      for (int y = top; y < top + side; ++y)
        for (int x = left; x < left + side; ++x) {
          if (corner(y, x) < leastCorner) continue;
          if (!alongColumns.shift.empty() && alongColumns.isSure(y, x) == 0) continue;
          if (!alongRows.shift.empty() && alongRows.isSure(y, x) == 0) continue;
          for (std::size_t k = 0; k < 4; ++k) {
            const DenseMotion& motion = k < 2 ? alongColumns : alongRows;
            values[k].push_back(motion.shift.empty() ? 0 : motion.shift(y, x)[int(k % 2)]);
          }
        }
      if (values[0].size() < leastPixels) continue;
      const auto median = [&](std::size_t k) { return percentile(values[k], 0.5); };
      places.push_back(
          {{left + side / 2.0, top + side / 2.0}, {median(0), median(1)}, {median(2), median(3)}});
    }
  return places;
}

/// Returns Pearson's correlation of values within their 2nd to 98th percentile; 0 if either is
/// constant.
double correlationOf(const std::vector<double>& a, const std::vector<double>& b) {
  const auto range = [](const std::vector<double>& v) {
    return std::pair(percentile(v, 0.02), percentile(v, 0.98));
  };
  const auto [a0, a1] = range(a);
  const auto [b0, b1] = range(b);
  double n = 0;
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] < a0 || a[k] > a1 || b[k] < b0 || b[k] > b1) continue;
    n += 1;
    sa += a[k];
    sb += b[k];
    saa += a[k] * a[k];
    sbb += b[k] * b[k];
    sab += a[k] * b[k];
  }
  const double va = n * saa - sa * sa;
  const double vb = n * sbb - sb * sb;
  return va > 0 && vb > 0 ? (n * sab - sa * sb) / std::sqrt(va * vb) : 0;
}

/// All measurements, for all centres.
struct Measured {
  std::vector<std::vector<PlaceMotion>> places;  ///< for each centre
  Occlusions alongColumns;
  Occlusions alongRows;
};

/// A component of the motions, and its axis in the image.
struct Component {
  std::array<double, 2> PlaceMotion::*motion;
  std::size_t axis;
};
constexpr Component columnsX{&PlaceMotion::alongColumns, 0};
constexpr Component columnsY{&PlaceMotion::alongColumns, 1};
constexpr Component rowsX{&PlaceMotion::alongRows, 0};
constexpr Component rowsY{&PlaceMotion::alongRows, 1};

std::vector<double> all(const std::vector<std::vector<PlaceMotion>>& lists,
                        const Component& component) {
  std::vector<double> values;
  for (const auto& places : lists)
    for (const PlaceMotion& place : places)
      values.push_back((place.*component.motion)[component.axis]);
  return values;
}

/// Returns the 90th percentile of a motion's absolute values.
double amountOf(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return percentile(std::move(values), 0.9);
}

/// Whether content moves up or down along the files' columns and sideways along their rows; none if
/// neither way is clearly stronger. One row of views that is read as several moves sideways along
/// both, further along the rows, which is neither.
std::optional<bool> isTransposed(const std::vector<std::vector<PlaceMotion>>& places) {
  constexpr double clearly = 2;
  const auto amount = [&](const Component& component) { return amountOf(all(places, component)); };
  const double straight = amount(columnsX) + amount(rowsY);
  const double across = amount(columnsY) + amount(rowsX);
  if (straight > clearly * across) return false;
  const bool isAcrossInBoth =
      amount(columnsY) >= amount(columnsX) && amount(rowsX) >= amount(rowsY);
  if (across > clearly * straight && isAcrossInBoth) return true;
  return std::nullopt;
}

/// Returns the existing view nearest to a place, preferably one with neighbours on all sides within
/// the grid.
Centre nearest(const GreyGrid& grid, const Centre& place) {
  constexpr int forLackOfOne = 16;  // a view four further away is better
  Centre best = place;
  int least = std::numeric_limits<int>::max();
  const auto lacks = [&](int row, int column) {
    const bool isInside = row >= 0 && row < grid.rows && column >= 0 && column < grid.columns;
    return isInside && !grid.has(row, column) ? 1 : 0;
  };
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.has(row, column)) continue;
      const int lacking = lacks(row - 1, column) + lacks(row + 1, column) + lacks(row, column - 1) +
                          lacks(row, column + 1);
      const int down = row - place.row;
      const int right = column - place.column;
      const int cost = down * down + right * right + forLackOfOne * lacking;
      if (cost >= least) continue;
      least = cost;
      best = {row, column};
    }
  return best;
}

Centre middleOf(const GreyGrid& grid) {
  return nearest(grid, {grid.rows / 2, grid.columns / 2});
}

/// Returns the view in the middle and one or two off it, in rows of both parities, which would show
/// a serpentine scan.
std::vector<Centre> centresOf(const GreyGrid& grid) {
  const auto [row, column] = middleOf(grid);
  std::vector<Centre> centres{{row, column}};
  if (grid.rows * grid.columns < 9) return centres;
  centres.push_back(nearest(grid, {std::max(row - 1, 0), column - grid.columns / 5}));
  if (grid.rows == 1) centres.push_back(nearest(grid, {row, column + grid.columns / 5}));
  if (grid.columns == 1) centres.push_back(nearest(grid, {row + grid.rows / 5, column}));
  return centres;
}

Sureness surenessOf(const Occlusions& votes, int forSure, double partForSure) {
  constexpr double forLikely = 3;  // standard deviations of as many votes by chance
  constexpr std::size_t areasForSure = 5;
  const int most = std::max(votes.ordered, votes.reversed);
  const auto areas =
      (votes.ordered > votes.reversed ? votes.orderedAreas : votes.reversedAreas).count();
  if (most >= forSure && most >= partForSure * votes.count() && areas >= areasForSure)
    return Sureness::sure;
  const bool isChance = 2 * most - votes.count() < forLikely * std::sqrt(double(votes.count()));
  return votes.isLeaning() && !isChance ? Sureness::likely : Sureness::unknown;
}

/// Whether one direction's own votes do not contradict the decision for both.
bool agrees(const Occlusions& own, bool isReversed) {
  constexpr int few = 6;
  constexpr double part = 0.7;
  return own.count() < few || (isReversed ? own.reversed : own.ordered) >= part * own.count();
}

/// Decides one direction alone, which needs more votes, because no other one confirms it.
void decideAlone(ViewOrder& order, const Occlusions& votes, bool& isReversed) {
  constexpr int forSure = 30;
  constexpr double partForSure = 0.9;
  order.sureness = std::min(order.sureness, surenessOf(votes, forSure, partForSure));
  isReversed = votes.isLeaning() && votes.reversed > votes.ordered;
}

/// Decides both directions: depths move along columns as along rows, which leaves two orders, each
/// the reverse of the other; occlusions decide.
void decideTogether(ViewOrder& order, bool& isUp, bool& isLeft) {
  constexpr int forSure = 30;
  constexpr double partForSure = 0.85;
  constexpr double correlationForSure = 0.7;
  const bool areAlike = order.correlation > 0;
  Occlusions votes = order.alongColumns;
  votes += areAlike ? order.alongRows : order.alongRows.backwards();
  isLeft = votes.reversed > votes.ordered;
  isUp = areAlike ? isLeft : !isLeft;
  order.sureness = surenessOf(votes, forSure, partForSure);
  const bool isCertain = std::abs(order.correlation) >= correlationForSure &&
                         agrees(order.alongColumns, isLeft) && agrees(order.alongRows, isUp);
  if (order.sureness == Sureness::sure && !isCertain) order.sureness = Sureness::likely;
  if (votes.isLeaning()) return;
  isLeft = false;  // cameras are seldom numbered backwards both ways
  isUp = !areAlike;
}

/// Whether one row of the grid contradicts another, or hardly any place moves to the neighbours of
/// one centre although many do at another.
bool isToAndFro(const std::vector<std::vector<PlaceMotion>>& places) {
  constexpr double clear = 0.5;
  constexpr std::size_t many = 60;
  bool isThere = false;
  bool isReversed = false;
  std::size_t fewest = places.front().size();
  std::size_t most = 0;
  for (const auto& list : places) {
    fewest = std::min(fewest, list.size());
    most = std::max(most, list.size());
    if (list.size() < many / 3) continue;
    const double correlation = correlationOf(all({list}, columnsX), all({list}, rowsY));
    isThere = isThere || correlation > clear;
    isReversed = isReversed || correlation < -clear;
  }
  return (isThere && isReversed) || (most >= many && 10 * fewest < most);
}

/// Whether different depths move differently enough to be compared.
bool isDeep(const std::vector<double>& motion, int step) {
  constexpr double least = 0.25;  // pixels, which the flow distinguishes
  return (percentile(motion, 0.95) - percentile(motion, 0.05)) * step >= least;
}

/// Exchanges rows and columns in what was measured.
void transpose(Measured& measured) {
  std::swap(measured.alongColumns, measured.alongRows);
  for (auto& places : measured.places)
    for (PlaceMotion& place : places) std::swap(place.alongColumns, place.alongRows);
}

/// Measures the grid and decides its order.
class Finder {
 public:
  Finder(const GreyGrid& grid, Views views, const Progress& progress)
      : m_progress(progress),
        m_grid(grid),
        m_views(std::move(views)),
        m_columns(m_views, grid, true),
        m_rows(m_views, grid, false) {}

  ViewOrder find() {
    const std::vector<Centre> centres = centresOf(m_grid);
    const auto count = double(centres.size());
    for (std::size_t k = 0; k < centres.size(); ++k)
      measure(centres[k], part(m_progress, 0.7 * double(k) / count, 0.7 * double(k + 1) / count));
    describePlaces();
    if (!canBeCompared()) return m_order;
    for (std::size_t k = 0; k < centres.size(); ++k)
      countOcclusions(m_around[k], part(m_progress, 0.7 + 0.3 * double(k) / count, 1));
    if (m_order.isTransposed) transpose(m_measured);
    m_order.alongColumns = m_measured.alongColumns;
    m_order.alongRows = m_measured.alongRows;
    decide();
    return m_order;
  }

 private:
  /// A centre with its neighbours.
  struct Around {
    Centre centre;
    Repetitions repeats;
    Neighbours columns;
    Neighbours rows;
  };

  /// Returns the neighbours at the step that the first centre determines.
  Neighbours neighboursOf(Direction& direction, const Centre& centre, const Progress& progress) {
    if (!direction.hasNeighbours()) return {};
    return m_around.empty() ? direction.neighboursThatMove(centre, progress)
                            : direction.neighbours(centre, direction.step());
  }

  void measure(const Centre& centre, const Progress& progress) {
    reportProgress(progress, 0);
    Neighbours columns = neighboursOf(m_columns, centre, part(progress, 0, 0.5));
    reportProgress(progress, 0.5);
    Neighbours rows = neighboursOf(m_rows, centre, part(progress, 0.5, 1));
    const cv::Mat1b view = m_views.at(centre.row, centre.column);
    Repetitions repeats{repetitions(view, 0), repetitions(view, 1)};
    m_measured.places.push_back(
        placesOf(view, repeats, motionPerView(columns), motionPerView(rows)));
    m_around.push_back({centre, std::move(repeats), std::move(columns), std::move(rows)});
  }

  /// Puts the middle view's motions into the result, in pixels of the original images.
  void describePlaces() {
    m_order.motions = m_measured.places.front();
    m_order.middleRow = m_around.front().centre.row;
    m_order.middleColumn = m_around.front().centre.column;
    for (PlaceMotion& place : m_order.motions)
      for (std::array<double, 2>* values : {&place.at, &place.alongColumns, &place.alongRows})
        for (double& value : *values) value /= m_views.scale();
    for (const auto& places : m_measured.places) m_order.places += int(places.size());
  }

  /// Whether there is structure and parallax, and one axis of motion for each direction.
  bool canBeCompared() {
    constexpr int fewest = 12;
    constexpr double least = 0.2;  // pixels over the steps
    if (m_order.places < fewest) return false;
    const auto amount = [&](const Component& x, const Component& y, int step) {
      return step *
             std::max(amountOf(all(m_measured.places, x)), amountOf(all(m_measured.places, y)));
    };
    if (std::max(amount(columnsX, columnsY, m_columns.step()),
                 amount(rowsX, rowsY, m_rows.step())) < least)
      return false;
    const std::optional<bool> transposed = hogelscope::isTransposed(m_measured.places);
    constexpr int enough = 60;  // to distinguish disorder from noise
    m_order.isInconsistent = !transposed && m_order.places >= enough;
    m_order.isTransposed = transposed.value_or(false);
    return transposed.has_value();
  }

  void countOcclusions(const Around& around, const Progress& progress) {
    reportProgress(progress, 0);
    const int axis = m_order.isTransposed ? 1 : 0;
    if (m_columns.hasNeighbours())
      m_measured.alongColumns +=
          m_columns.occlusions(around.centre, around.columns, around.repeats, axis);
    throwIfCancelled(progress);
    if (m_rows.hasNeighbours())
      m_measured.alongRows +=
          m_rows.occlusions(around.centre, around.rows, around.repeats, 1 - axis);
  }

  /// Decides the order; rows and columns are now those of cameras.
  void decide() {
    const std::vector<double> x = all(m_measured.places, columnsX);
    const std::vector<double> y = all(m_measured.places, rowsY);
    const auto [stepX, stepY] = m_order.isTransposed ? std::pair(m_rows.step(), m_columns.step())
                                                     : std::pair(m_columns.step(), m_rows.step());
    m_order.middleMotion = {percentile(x, 0.5) / m_views.scale(),
                            percentile(y, 0.5) / m_views.scale()};
    const bool hasColumns = (m_order.isTransposed ? m_rows : m_columns).hasNeighbours();
    const bool hasRows = (m_order.isTransposed ? m_columns : m_rows).hasNeighbours();
    if (hasColumns && hasRows && isDeep(x, stepX) && isDeep(y, stepY))
      m_order.correlation = correlationOf(x, y);
    if (isToAndFro(m_measured.places)) {
      m_order.isInconsistent = true;
      return;
    }
    bool isUp = false;
    bool isLeft = false;
    constexpr double clear = 0.5;
    if (std::abs(m_order.correlation) >= clear) {
      decideTogether(m_order, isUp, isLeft);
    } else {
      m_order.sureness = Sureness::sure;
      if (hasColumns) decideAlone(m_order, m_order.alongColumns, isLeft);
      if (hasRows) decideAlone(m_order, m_order.alongRows, isUp);
    }
    m_order.rows = isUp ? RowOrder::bottomUp : RowOrder::topDown;
    m_order.columns = isLeft ? ColumnOrder::rightLeft : ColumnOrder::leftRight;
  }

  const Progress& m_progress;
  const GreyGrid& m_grid;
  Views m_views;
  Direction m_columns;
  Direction m_rows;
  Measured m_measured;
  std::vector<Around> m_around;
  ViewOrder m_order;
};

}  // namespace

bool hasVerticalParallax(const ViewOrder& order) {
  constexpr std::size_t fewest = 4;  // places; few are found again in views far apart
  constexpr double least = 0.1;      // pixels per view
  constexpr double clearly = 4;
  if (order.motions.size() < fewest) return false;
  const auto isVertical = [&](const Component& x, const Component& y) {
    const double amount = amountOf(all({order.motions}, y));
    return amount > least && amount > clearly * amountOf(all({order.motions}, x));
  };
  return isVertical(columnsX, columnsY) || isVertical(rowsX, rowsY);
}

ViewOrder findViewOrder(const GreyGrid& grid, const Progress& progress) {
  constexpr int leastSide = 32;  // of the scaled views
  if (grid.rows * grid.columns < 2) return {};
  Views views(grid);
  const Centre middle = middleOf(grid);
  const cv::Size size = views.at(middle.row, middle.column).size();
  if (std::min(size.width, size.height) < leastSide) return {};
  return Finder(grid, std::move(views), progress).find();
}

}  // namespace hogelscope
