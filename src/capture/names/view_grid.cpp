// SPDX-License-Identifier: BSD-3-Clause
#include "capture/names/view_grid.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <numeric>

#include "capture/names/number_gaps.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

using Cells = std::vector<const NamedView*>;  // row by row; null: missing

/// Numbers of rows or columns, ascending.
class NumberAxis {
 public:
  explicit NumberAxis(std::vector<std::int64_t> values) : m_values(std::move(values)) {
    std::sort(m_values.begin(), m_values.end());
    m_values.erase(std::unique(m_values.begin(), m_values.end()), m_values.end());
    for (const std::int64_t value : m_values) m_step = std::gcd(m_step, value - m_values.front());
    m_step = std::max<std::int64_t>(m_step, 1);
  }

  /// Returns the number of rows or columns, including those missing between first and last.
  [[nodiscard]] double size() const {
    return double(m_values.back() - m_values.front()) / double(m_step) + 1;
  }
  [[nodiscard]] double sizeOfFound() const { return double(m_values.size()); }
  void fill() {
    const std::int64_t last = m_values.back();
    const std::int64_t first = m_values.front();
    m_values.clear();
    for (std::int64_t value = first; value <= last; value += m_step) m_values.push_back(value);
  }
  [[nodiscard]] const std::vector<std::int64_t>& values() const { return m_values; }
  [[nodiscard]] std::int64_t step() const { return m_step; }
  [[nodiscard]] std::size_t placeOf(std::int64_t value) const {
    return std::size_t(std::lower_bound(m_values.begin(), m_values.end(), value) -
                       m_values.begin());
  }

 private:
  std::vector<std::int64_t> m_values;
  std::int64_t m_step = 0;
};

std::string nameOf(const NamedView& view) {
  return view.file.filename().string();
}

/// Whether so few views may be a cross or a star in a grid: at least one in a hundred.
bool mayBeSparse(const std::vector<NamedView>& views, double cells) {
  return 100 * double(views.size()) >= cells;
}

/// Throws InputError because too many views are missing; `columns` and `rows` are an estimate of
/// the grid.
[[noreturn]] void refuseHoles(const std::vector<NamedView>& views, const GridSource& source,
                              double cells, double columns, double rows) {
  std::string advice;
  if (source.directions[0] > 0)
    advice = "they are no part of a grid of " +
             pairText(source.directions[0], source.directions[1]) + ": mend display.directions";
  else if (mayBeSparse(views, columns * rows))
    advice = "if the others are missing give display.directions, such as [" + numberText(columns) +
             "," + numberText(rows) + "]";
  if (!advice.empty()) advice += ", or ";
  throw InputError(
      source.folder.string(), "views",
      "only " + std::to_string(views.size()) + " of " + numberText(cells) +
          " views are there, such as " + nameOf(views.front()) + ": " + advice +
          (source.isPatternGiven ? "mend lightField.pattern, \"" + source.pattern + "\""
                                 : "if they are read the wrong way give lightField.pattern"));
}

/// Whether more than half of the cells are filled.
bool isFull(const std::vector<NamedView>& views, double cells) {
  return 2 * double(views.size()) > cells;
}

using PlaceOf = std::function<std::size_t(const NamedView&)>;

Cells placed(const std::vector<NamedView>& views, std::size_t count, const PlaceOf& placeOf,
             const GridSource& source) {
  Cells cells(count);
  for (const NamedView& view : views) {
    const NamedView*& cell = cells[placeOf(view)];
    if (cell != nullptr)
      throw InputError(source.folder.string(), "views",
                       nameOf(view) + " and " + nameOf(*cell) + " are the same view");
    cell = &view;
  }
  return cells;
}

/// Returns "3 of 81 views are missing, …: (row, column) 0 0, 0 1, 0 7"; `numbersOf` names a cell.
std::string missingText(const Cells& cells, const char* what,
                        const std::function<std::string(std::size_t)>& numbersOf) {
  constexpr std::size_t mostNamed = 8;
  std::size_t missing = 0;
  std::string names;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (cells[k] != nullptr) continue;
    if (missing < mostNamed) names += (missing == 0 ? "" : ", ") + numbersOf(k);
    ++missing;
  }
  if (missing == 0) return {};
  if (missing > mostNamed) names += ", …";
  return "lightField: " + std::to_string(missing) + " of " + std::to_string(cells.size()) +
         " views are missing and shown black: " + what + " " + names;
}

ViewFiles filesOf(const Cells& cells, std::size_t rows, std::size_t columns) {
  ViewFiles grid;
  grid.rows = int(rows);
  grid.columns = int(columns);
  for (const NamedView* cell : cells)
    grid.files.push_back(cell == nullptr ? fs::path() : cell->file);
  return grid;
}

/// Returns the mean coordinate of `count` cells from `first` on, `step` apart.
std::optional<double> meanOf(const Cells& cells, std::optional<double> NamedView::*coordinate,
                             std::size_t first, std::size_t step, int count) {
  double sum = 0;
  int found = 0;
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    const NamedView* const view = cells[first + k * step];
    if (view == nullptr) continue;
    if (!(view->*coordinate)) return std::nullopt;
    sum += *(view->*coordinate);
    ++found;
  }
  return found > 0 ? std::optional(sum / found) : std::nullopt;
}

void addPositions(ViewFiles& grid, const Cells& cells) {
  const auto columns = std::size_t(grid.columns);
  const auto pair = [](std::optional<double> from, std::optional<double> to) {
    return from && to ? std::optional(std::array{*from, *to}) : std::nullopt;
  };
  if (grid.columns > 1)
    grid.columnsFromTo = pair(meanOf(cells, &NamedView::x, 0, columns, grid.rows),
                              meanOf(cells, &NamedView::x, columns - 1, columns, grid.rows));
  if (grid.rows > 1)
    grid.rowsFromTo = pair(meanOf(cells, &NamedView::y, 0, 1, grid.columns),
                           meanOf(cells, &NamedView::y, cells.size() - columns, 1, grid.columns));
}

/// Returns a warning if the directions that are given are not those of the names; otherwise "".
std::string ignoredText(const GridSource& source, const ViewFiles& grid) {
  const auto [columns, rows] = source.directions;
  if (columns < 1 || (columns == grid.columns && rows == grid.rows)) return {};
  return "display.directions: " + pairText(columns, rows) +
         " is ignored, because the file names say " + pairText(grid.columns, grid.rows) +
         " views; lightField.pattern reads the names in another way";
}

ViewFiles gridOfNumbers(const std::vector<NamedView>& views, const GridSource& source) {
  std::vector<std::int64_t> rowNumbers;
  std::vector<std::int64_t> columnNumbers;
  for (const NamedView& view : views) {
    rowNumbers.push_back(view.row.value_or(0));
    columnNumbers.push_back(view.column.value_or(0));
  }
  NumberAxis rows(std::move(rowNumbers));
  NumberAxis columns(std::move(columnNumbers));
  const double all = rows.size() * columns.size();
  const bool isGiven =
      columns.size() == source.directions[0] && rows.size() == source.directions[1];
  if (isFull(views, all) || (isGiven && mayBeSparse(views, all))) {
    rows.fill();
    columns.fill();
  } else if (const double cells = rows.sizeOfFound() * columns.sizeOfFound();
             !isFull(views, cells)) {
    refuseHoles(views, source, cells, columns.size(), rows.size());
  }
  const std::size_t width = columns.values().size();
  const auto placeOf = [&](const NamedView& view) {
    return rows.placeOf(view.row.value_or(0)) * width + columns.placeOf(view.column.value_or(0));
  };
  const Cells cells = placed(views, rows.values().size() * width, placeOf, source);
  ViewFiles grid = filesOf(cells, rows.values().size(), width);
  grid.missing = missingText(cells, "(row, column)", [&](std::size_t k) {
    return std::to_string(rows.values()[k / width]) + " " +
           std::to_string(columns.values()[k % width]);
  });
  addPositions(grid, cells);
  grid.ignored = ignoredText(source, grid);
  return grid;
}

/// The grid of running numbers that are divided by their step.
struct Running {
  std::int64_t first = 0;
  std::size_t rows = 1;
  std::size_t columns = 1;
};

/// Whether `count` numbers form the given grid; a part of the last line may be missing at the end,
/// or of the first line at the beginning.
bool isCount(std::size_t count, const GridSource& source) {
  const auto columns = std::size_t(std::max(source.directions[0], 0));
  const auto rows = std::size_t(std::max(source.directions[1], 0));
  const bool isByColumns =
      source.scan == ViewScan::columns || source.scan == ViewScan::columnsSerpentine;
  return columns == 0 ||
         (count <= columns * rows && count + (isByColumns ? rows : columns) > columns * rows);
}

/// Returns the grid of `count` numbers from `first` on, including missing ones.
Running runningOf(std::int64_t first, std::size_t count, const GridSource& source) {
  const auto columns = std::size_t(std::max(source.directions[0], 0));
  const auto rows = std::size_t(std::max(source.directions[1], 0));
  if (columns == 0) {
    const auto side = std::size_t(std::llround(std::sqrt(double(count))));
    return side * side == count ? Running{first, side, side} : Running{first, 1, count};
  }
  const std::size_t cells = columns * rows;
  if (!isCount(count, source))
    throw InputError(source.folder.string(), "views",
                     std::to_string(count) + " views do not make a grid of " +
                         pairText(source.directions[0], source.directions[1]) +
                         "; mend display.directions");
  const std::int64_t last = first + std::int64_t(count) - 1;
  const auto cellCount = std::int64_t(cells);
  if (count == cells || first <= 1) return {first, rows, columns};
  return {last < cellCount ? 0 : last + 1 - cellCount, rows, columns};
}

/// Returns a given grid with missing views, which are counted from 0 or from 1; none if the views
/// are not in it, or are nearly all. The views that exist are assumed to be symmetric, as in a
/// cross, a star or a circle.
std::optional<Running> sparseRunning(const std::vector<NamedView>& views, const NumberAxis& numbers,
                                     const GridSource& source) {
  const auto [columns, rows] = source.directions;
  if (columns < 1 || rows < 1 || !mayBeSparse(views, double(columns) * rows)) return std::nullopt;
  const std::int64_t cells = std::int64_t(columns) * rows;
  const std::int64_t first = numbers.values().front(), last = numbers.values().back();
  const bool hasHoles = double(views.size()) < numbers.size() || numbers.step() > 1;
  if (last > cells || !hasHoles) return std::nullopt;
  const bool isSymmetric = first + last == cells - 1 || first + last == cells + 1;
  const bool isNearlyAll =
      isFull(views, numbers.size()) && isCount(std::size_t(numbers.size()), source);
  if (isNearlyAll && !isSymmetric) return std::nullopt;
  const std::int64_t begin = last == cells || first + last == cells + 1 ? 1 : 0;
  if (first < begin) return std::nullopt;
  return Running{begin, std::size_t(rows), std::size_t(columns)};
}

/// Returns advice if one file too many may prevent a square grid; otherwise "".
std::string surplusText(const std::vector<NamedView>& views, const GridSource& source) {
  constexpr std::size_t leastSide = 5;  // rows of 10 and 17 cameras are usual
  const std::size_t count = views.size();
  const auto side = std::size_t(std::llround(std::sqrt(double(count - 1))));
  if (source.directions[0] > 0 || side < leastSide || side * side + 1 != count) return {};
  const auto last = std::ranges::max_element(
      views, {}, [](const NamedView& view) { return view.number.value_or(0); });
  const std::string square = std::to_string(side);
  return "lightField: " + std::to_string(count) +
         " views are read as one row; without one they are " + square + "×" + square +
         ": lightField.exclude=" + nameOf(*last) +
         " leaves the last one out, display.directions=[" + std::to_string(count) +
         ",1] says that it is a row";
}

std::optional<double> coordinateOf(const std::string& text) {
  const std::optional<double> value = numberOf(text.substr(text.front() == '+' ? 1 : 0));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::int64_t integerOf(const std::string& text) {
  std::int64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// The views of a grid that are counted line by line, some of which may be missing.
struct Counted {
  SequenceGrid grid;
  std::function<std::int64_t(std::int64_t)> viewOf;    ///< the view that a number counts
  std::function<std::int64_t(std::int64_t)> numberOf;  ///< the number of a view
};

/// Returns the numbers without their gaps, in the given order.
Counted inOrder(std::vector<std::int64_t> order, const GridSource& source) {
  Counted counted{gridOfSequence(order.size(), source), {}, {}};
  std::map<std::int64_t, std::int64_t> places;
  for (const std::int64_t number : order) places.emplace(number, std::int64_t(places.size()));
  counted.viewOf = [places = std::move(places)](std::int64_t number) { return places.at(number); };
  counted.numberOf = [order = std::move(order)](std::int64_t view) {
    return order[std::size_t(view)];
  };
  return counted;
}

/// Returns the views of a part of a larger grid; none if other directions are given.
std::optional<Counted> asSubGrid(const SubGrid& grid, std::int64_t first,
                                 const GridSource& source) {
  const bool isByColumns =
      source.scan == ViewScan::columns || source.scan == ViewScan::columnsSerpentine;
  const std::int64_t columns = isByColumns ? grid.lines : grid.count;
  const std::int64_t rows = isByColumns ? grid.count : grid.lines;
  const bool isGiven = source.directions[0] > 0;
  if (isGiven && (source.directions[0] != columns || source.directions[1] != rows))
    return std::nullopt;
  const auto [step, pitch, lines, count] = grid;
  return Counted{{std::size_t(rows), std::size_t(columns), source.scan},
                 // Named again: clang captures no structured bindings.
                 [first, step = step, pitch = pitch, count = count](std::int64_t number) {
                   return (number - first) / pitch * count + (number - first) % pitch / step;
                 },
                 [first, step = step, pitch = pitch, count = count](std::int64_t view) {
                   return first + view / count * pitch + view % count * step;
                 }};
}

/// Returns the views whose numbers are regular, with missing ones. Throws InputError.
Counted withHoles(const std::vector<NamedView>& views, const NumberAxis& numbers,
                  const GridSource& source) {
  const std::optional<Running> sparse = sparseRunning(views, numbers, source);
  if (!sparse && !isFull(views, numbers.size())) {
    const double side = std::ceil(std::sqrt(double(numbers.size())));
    refuseHoles(views, source, numbers.size(), side, side);
  }
  const std::int64_t step = sparse ? 1 : numbers.step();
  const auto [begin, rows, columns] =
      sparse ? *sparse
             : runningOf(numbers.values().front() / step, std::size_t(numbers.size()), source);
  const std::int64_t first = (sparse ? 0 : numbers.values().front() % step) + begin * step;
  return {{rows, columns, source.scan},
          [=](std::int64_t number) { return (number - first) / step; },
          [=](std::int64_t view) { return first + view * step; }};
}

/// Whether views without gaps between them make the grid that is given.
bool isGivenCount(std::size_t count, const GridSource& source) {
  const auto [columns, rows] = source.directions;
  return columns > 0 && rows > 0 && std::size_t(columns) * std::size_t(rows) == count;
}

/// Returns the views of running numbers. Throws InputError.
Counted countedOf(const std::vector<NamedView>& views, const NumberAxis& numbers,
                  const GridSource& source) {
  const std::vector<std::int64_t>& ascending = numbers.values();
  const bool isEachAlone = ascending.size() == views.size();
  if (isEachAlone && double(views.size()) < numbers.size()) {
    if (areTimes(ascending)) return inOrder(ascending, source);
    if (auto order = begunAgain(ascending)) return inOrder(std::move(*order), source);
    if (const auto grid = repeatedGaps(ascending))
      if (const auto counted = asSubGrid(*grid, ascending.front(), source)) return *counted;
    if (isGivenCount(views.size(), source)) return inOrder(ascending, source);
  }
  return withHoles(views, numbers, source);
}

ViewFiles gridOfRunning(const std::vector<NamedView>& views, const GridSource& source) {
  std::vector<std::int64_t> found;
  found.reserve(views.size());
  for (const NamedView& view : views) found.push_back(view.number.value_or(0));
  const NumberAxis numbers(std::move(found));
  const Counted counted = countedOf(views, numbers, source);
  const auto& [rows, columns, scan] = counted.grid;
  const auto placeOf = [&](const NamedView& view) {
    return counted.grid.cellOf(std::size_t(counted.viewOf(view.number.value_or(0))));
  };
  const Cells cells = placed(views, rows * columns, placeOf, source);
  ViewFiles grid = filesOf(cells, rows, columns);
  grid.isCounted = true;
  grid.missing = missingText(cells, "number", [&](std::size_t k) {
    return std::to_string(counted.numberOf(std::int64_t(counted.grid.viewOf(k))));
  });
  constexpr double mostMissing = 0.25;
  grid.isLoose =
      source.directions[0] < 1 && double(views.size()) < (1 - mostMissing) * double(cells.size());
  if (rows == 1) grid.surplus = surplusText(views, source);
  return grid;
}

/// A division of coordinates into groups of close values.
struct Gathering {
  std::vector<double> begins;  ///< least values of all groups but the first
  double spread = 0;           ///< range of the widest group

  [[nodiscard]] std::size_t size() const { return begins.size() + 1; }
  [[nodiscard]] std::size_t placeOf(double value) const {
    return std::size_t(std::upper_bound(begins.begin(), begins.end(), value) - begins.begin());
  }
};

Gathering gatheringOf(const std::vector<double>& sorted, double leastGap) {
  Gathering result;
  double first = sorted.front();
  for (std::size_t k = 1; k < sorted.size(); ++k) {
    if (sorted[k] - sorted[k - 1] >= leastGap) {
      result.begins.push_back(sorted[k]);
      first = sorted[k];
    }
    result.spread = std::max(result.spread, sorted[k] - first);
  }
  return result;
}

/// Returns all values as one group, and the few divisions that have the clearest gaps.
std::vector<Gathering> gatheringsOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double range = values.back() - values.front();
  std::vector<double> gaps;
  for (std::size_t k = 1; k < values.size(); ++k) gaps.push_back(values[k] - values[k - 1]);
  std::sort(gaps.begin(), gaps.end(), std::greater<>());
  gaps.push_back(0);
  constexpr double rounding = 1e-6;                  // of the range
  std::vector<std::pair<double, double>> clarities;  // of a least gap
  for (std::size_t k = 0; k + 1 < gaps.size(); ++k)
    if (gaps[k] > rounding * range)
      clarities.emplace_back(gaps[k] / std::max(gaps[k + 1], rounding * range), gaps[k]);
  std::sort(clarities.begin(), clarities.end(), std::greater<>());
  constexpr std::size_t most = 8;
  std::vector<Gathering> gatherings{gatheringOf(values, 2 * range + 1)};
  for (std::size_t k = 0; k < std::min(most, clarities.size()); ++k)
    gatherings.push_back(gatheringOf(values, clarities[k].second));
  return gatherings;
}

/// Whether no two views are in one cell.
bool isEachAlone(const std::vector<NamedView>& views, const Gathering& x, const Gathering& y) {
  std::vector<bool> taken(x.size() * y.size());
  for (const NamedView& view : views) {
    const std::size_t at = y.placeOf(view.y.value_or(0)) * x.size() + x.placeOf(view.x.value_or(0));
    if (taken[at]) return false;
    taken[at] = true;
  }
  return true;
}

/// Returns the division with few missing views and narrow groups; a single row would have none
/// missing, but would be as high as the grid.
std::optional<std::pair<Gathering, Gathering>> bestGathering(const std::vector<NamedView>& views) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const NamedView& view : views) {
    xs.push_back(view.x.value_or(0));
    ys.push_back(view.y.value_or(0));
  }
  const std::vector<Gathering> ofX = gatheringsOf(std::move(xs));
  const std::vector<Gathering> ofY = gatheringsOf(std::move(ys));
  const double range = std::max(ofX.front().spread, ofY.front().spread);
  std::optional<std::pair<Gathering, Gathering>> best;
  double least = 0;
  for (const Gathering& x : ofX)
    for (const Gathering& y : ofY) {
      const double cells = double(x.size()) * double(y.size());
      if (!isFull(views, cells)) continue;
      const double cost = cells / double(views.size()) + (x.spread + y.spread) / range;
      if ((best && cost >= least) || !isEachAlone(views, x, y)) continue;
      least = cost;
      best = {x, y};
    }
  return best;
}

ViewFiles gridOfCoordinates(const std::vector<NamedView>& views, const GridSource& source) {
  const auto gathering = bestGathering(views);
  if (!gathering)
    throw InputError(source.folder.string(), "views",
                     "the coordinates in names such as " + nameOf(views.front()) +
                         " do not make a grid; give lightField.pattern");
  const auto& [x, y] = *gathering;
  const std::size_t width = x.size();
  const auto placeOf = [&x = x, &y = y, width](const NamedView& view) {
    return y.placeOf(view.y.value_or(0)) * width + x.placeOf(view.x.value_or(0));
  };
  const Cells cells = placed(views, width * y.size(), placeOf, source);
  ViewFiles grid = filesOf(cells, y.size(), width);
  grid.missing = missingText(cells, "(row, column)", [width](std::size_t k) {
    return std::to_string(k / width) + " " + std::to_string(k % width);
  });
  addPositions(grid, cells);
  return grid;
}

}  // namespace

NamedView viewNamed(const fs::path& file, const std::map<char, std::string>& numbers) {
  NamedView view{file, {}, {}, {}, {}, {}};
  for (const auto& [letter, text] : numbers) {
    if (letter == 'x' || letter == 'y')
      (letter == 'x' ? view.x : view.y) = coordinateOf(text);
    else
      (letter == 'R' ? view.row : letter == 'C' ? view.column : view.number) = integerOf(text);
  }
  return view;
}

std::size_t SequenceGrid::placeIn(std::size_t line, std::size_t at) const {
  const bool isToAndFro = scan == ViewScan::serpentine || scan == ViewScan::columnsSerpentine;
  return isToAndFro && line % 2 == 1 ? (isByColumns() ? rows : columns) - 1 - at : at;
}

std::size_t SequenceGrid::cellOf(std::size_t k) const {
  const std::size_t length = isByColumns() ? rows : columns;
  const std::size_t line = k / length, at = placeIn(line, k % length);
  return isByColumns() ? at * columns + line : line * columns + at;
}

std::size_t SequenceGrid::viewOf(std::size_t cell) const {
  const std::size_t row = cell / columns, column = cell % columns;
  return isByColumns() ? column * rows + placeIn(column, row)
                       : row * columns + placeIn(row, column);
}

SequenceGrid gridOfSequence(std::size_t count, const GridSource& source) {
  const Running running = runningOf(0, count, source);
  return {running.rows, running.columns, source.scan};
}

std::vector<fs::path> ViewFiles::found() const {
  std::vector<fs::path> result;
  for (const fs::path& file : files)
    if (!file.empty()) result.push_back(file);
  return result;
}

ViewFiles gridOf(const std::vector<NamedView>& views, const GridSource& source) {
  const NamedView& first = views.front();
  ViewFiles grid = first.number                ? gridOfRunning(views, source)
                   : first.row || first.column ? gridOfNumbers(views, source)
                                               : gridOfCoordinates(views, source);
  grid.pattern = source.pattern;
  return grid;
}

}  // namespace hogelscope
