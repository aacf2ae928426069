// SPDX-License-Identifier: BSD-3-Clause
// The columns of traces as trackers, SLAM programs and spreadsheets write them: what separates the
// cells, what the columns are called, and in which units they count.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hogelscope {

using TraceCells = std::vector<std::string_view>;

/// Returns what separates the cells of a line: ';', a tab or ',', or ' ' for runs of spaces.
char traceSeparatorOf(std::string_view line);

/// Returns a line's cells without the spaces around them, and without the quotes.
TraceCells traceCellsOf(std::string_view line, char separator);

/// Returns the number in a cell; a comma is a decimal point unless commas separate the cells.
std::optional<double> traceNumberOf(std::string_view cell, char separator);

/// Where the columns of time, x, y and z are, and what one unit of each is in seconds or metres.
struct TraceColumns {
  static constexpr std::size_t none = std::size_t(-1);
  std::array<std::size_t, 4> at{none, none, none, none};
  std::array<double, 4> units{1, 1, 1, 1};
  bool hasTimeUnit = false;  ///< a name says the unit of the time
  std::string names{};       ///< says which columns were taken, if not those named time, x, y, z
};

/// Finds the columns by their usual names, such as "timestamp", "tx", "p_RS_R_x [m]", "Zeit"; none
/// if there is no time, x or y.
std::optional<TraceColumns> traceColumnsOf(const TraceCells& names);

/// Finds the columns of lines without names by the number of cells: time, x, y[, z], or with a
/// quaternion behind z, which must have the length 1, as TUM's and EuRoC's trajectories have it.
std::optional<TraceColumns> traceColumnsOf(const TraceCells& numbers, char separator);

/// Returns the unit of a clock, seconds, that says `time`: more than a tenth of a million years
/// are milliseconds, microseconds or nanoseconds since 1970.
double traceClockUnitOf(double time);

}  // namespace hogelscope
