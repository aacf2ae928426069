// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/trace_columns.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/text.h"

namespace hogelscope {

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view withoutBlanks(std::string_view text) {
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// A column's name in small letters, without its unit, and the unit.
struct ColumnName {
  std::string name;
  std::string unit;
};

ColumnName columnNameOf(std::string_view cell) {
  std::string text = lowerCase(std::string(withoutBlanks(cell)));
  std::string unit;
  if (const auto bracket = text.find_first_of("[("); bracket != std::string::npos) {
    const auto end = text.find_first_of("])", bracket);
    if (end != std::string::npos) unit = text.substr(bracket + 1, end - bracket - 1);
    text = std::string(withoutBlanks(std::string_view(text).substr(0, bracket)));
  }
  std::ranges::replace(text, ' ', '_');
  if (const auto last = text.rfind('_'); unit.empty() && last != std::string::npos) {
    const std::string behind = text.substr(last + 1);
    constexpr std::array<std::string_view, 9> suffixes{"ns", "us", "ms",   "s", "sec",
                                                       "mm", "cm", "nsec", "m"};
    if (std::ranges::find(suffixes, behind) != suffixes.end()) {
      unit = behind;
      text.resize(last);
    }
  }
  return {text, unit};
}

/// Returns one unit in seconds (axis 0) or metres; none for an unknown one.
std::optional<double> unitOf(const std::string& unit, std::size_t axis) {
  struct Unit {
    std::string_view name;
    double size;
  };
  static constexpr std::array<Unit, 13> times{{{"ns", 1e-9},
                                               {"nsec", 1e-9},
                                               {"nanoseconds", 1e-9},
                                               {"us", 1e-6},
                                               {"µs", 1e-6},
                                               {"microseconds", 1e-6},
                                               {"ms", 1e-3},
                                               {"msec", 1e-3},
                                               {"milliseconds", 1e-3},
                                               {"s", 1},
                                               {"sec", 1},
                                               {"secs", 1},
                                               {"seconds", 1}}};
  static constexpr std::array<Unit, 5> lengths{
      {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}, {"meters", 1}, {"metres", 1}}};
  const auto units = axis == 0 ? std::span<const Unit>(times) : std::span<const Unit>(lengths);
  const auto found = std::ranges::find(units, unit, &Unit::name);
  return found == units.end() ? std::nullopt : std::optional(found->size);
}

/// Whether a name is one of a time's, or of the place along an axis: x, tx, pos_x, p_RS_R_x …
bool isNameOf(const std::string& name, std::size_t axis) {
  if (axis == 0) {
    constexpr std::array<std::string_view, 7> times{"time",  "timestamp",  "t",      "zeit",
                                                    "stamp", "time_stamp", "seconds"};
    return std::ranges::find(times, name) != times.end();
  }
  const char letter = "txyz"[axis];
  constexpr std::array<std::string_view, 14> before{
      "",     "t",    "t_",        "p",         "p_",       "pos",     "pos_",
      "pos.", "pos-", "position_", "position.", "position", "p_rs_r_", "head_"};
  return std::ranges::any_of(before, [&](std::string_view begin) {
    return name.size() == begin.size() + 1 && name.starts_with(begin) && name.back() == letter;
  });
}

/// Sets the column of an axis, by its plain name if there is one. Returns whether it has one.
bool findColumn(const TraceCells& names, std::size_t axis, TraceColumns& columns) {
  const std::string_view plain = std::array<std::string_view, 4>{"time", "x", "y", "z"}[axis];
  const auto exact = std::ranges::find(names, plain);
  if (exact != names.end()) {
    columns.at[axis] = std::size_t(exact - names.begin());
    return true;
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    const ColumnName column = columnNameOf(names[k]);
    const std::optional<double> unit = column.unit.empty() ? 1 : unitOf(column.unit, axis);
    if (!isNameOf(column.name, axis) || !unit) continue;
    columns.at[axis] = k;
    columns.units[axis] = *unit;
    if (axis == 0) columns.hasTimeUnit = !column.unit.empty();
    columns.names += (columns.names.empty() ? "" : ", ") + printable(std::string(names[k])) +
                     " as " + std::string(plain) +
                     (column.unit.empty() ? "" : " in " + printable(column.unit));
    return true;
  }
  return false;
}

}  // namespace

char traceSeparatorOf(std::string_view line) {
  constexpr std::size_t least = 3;  // time, x, y
  const auto splits = [&](char separator) { return traceCellsOf(line, separator).size() >= least; };
  if (splits(';')) return ';';
  // A comma before a tab separates already; others are decimal.
  if (splits('\t') && line.find(",\t") == std::string_view::npos) return '\t';
  if (line.find(',') != std::string_view::npos) return ',';
  return splits(' ') ? ' ' : ',';
}

TraceCells traceCellsOf(std::string_view line, char separator) {
  TraceCells cells;
  if (separator == ' ') {
    while (!(line = withoutBlanks(line)).empty()) {
      const std::size_t end = std::min(line.find_first_of(blanks), line.size());
      cells.push_back(line.substr(0, end));
      line.remove_prefix(end);
    }
    return cells;
  }
  for (std::size_t end = 0; end != std::string_view::npos;) {
    const std::size_t quote = line.starts_with('"') ? line.find('"', 1) : 0;
    end = line.find(separator, quote);
    const std::string_view cell = withoutBlanks(line.substr(0, end));
    const bool isQuoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
    cells.push_back(isQuoted ? withoutBlanks(cell.substr(1, cell.size() - 2)) : cell);
    line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
  }
  return cells;
}

std::optional<double> traceNumberOf(std::string_view cell, char separator) {
  if (const std::optional<double> number = numberOf(cell)) return number;
  if (separator == ',' || std::ranges::count(cell, ',') != 1) return std::nullopt;
  std::string point(cell);
  std::ranges::replace(point, ',', '.');
  return numberOf(point);
}

std::optional<TraceColumns> traceColumnsOf(const TraceCells& names) {
  TraceColumns columns;
  for (std::size_t axis = 0; axis < columns.at.size(); ++axis)
    if (!findColumn(names, axis, columns) && axis < 3) return std::nullopt;
  constexpr std::array<std::string_view, 3> ofQuaternions{"qw", "q_w", "q_rs_w"};
  const bool isTurned = std::ranges::any_of(names, [&](std::string_view cell) {
    return std::ranges::find(ofQuaternions, columnNameOf(cell).name) != ofQuaternions.end();
  });
  if (isTurned && !columns.names.empty()) columns.names += "; its orientations are not used";
  return columns;
}

std::optional<TraceColumns> traceColumnsOf(const TraceCells& numbers, char separator) {
  TraceColumns columns;
  columns.at = {0, 1, 2, numbers.size() == 3 ? TraceColumns::none : 3};
  if (numbers.size() == 3 || numbers.size() == 4) return columns;
  constexpr std::size_t withQuaternion = 8;
  if (numbers.size() < withQuaternion) return std::nullopt;
  double square = 0;
  for (std::size_t k = 4; k < withQuaternion; ++k) {
    const double part = traceNumberOf(numbers[k], separator).value_or(2);
    square += part * part;
  }
  if (!(std::abs(square - 1) < 0.01)) return std::nullopt;
  columns.names = "time, x, y, z of lines with an orientation, which is not used";
  return columns;
}

double traceClockUnitOf(double time) {
  const double size = std::abs(time);
  return size >= 1e17 ? 1e-9 : size >= 1e14 ? 1e-6 : size >= 1e11 ? 1e-3 : 1;
}

}  // namespace hogelscope
