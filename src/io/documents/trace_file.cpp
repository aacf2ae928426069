// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/trace_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/trace_columns.h"

namespace hogelscope {

namespace {

/// Formats a cell for an error line: short, and harmless to a terminal.
std::string shown(std::string_view cell) {
  constexpr std::size_t longest = 40;
  std::string text(cell.substr(0, longest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  return "\"" + text + (cell.size() > longest ? "…\"" : "\"");
}

/// A clock of more digits than a double has; its differences are exact.
std::optional<std::int64_t> longClockOf(std::string_view cell) {
  constexpr std::size_t digitsOfDouble = 15;
  std::int64_t ticks = 0;
  const char* const end = cell.data() + cell.size();
  const auto [stop, error] = std::from_chars(cell.data(), end, ticks);
  const bool isWhole = error == std::errc() && stop == end && cell.size() > digitsOfDouble;
  return isWhole ? std::optional(ticks) : std::nullopt;
}

/// Reads a trace line by line.
class TraceReader {
 public:
  TraceReader(double distance, const TraceParams& params, std::vector<std::string>* notes)
      : m_params(params), m_distance(distance), m_notes(notes) {
    m_trace.holds = params.holds;
  }

  void read(std::string_view line) {
    ++m_line;
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) return;
    line = line.substr(0, line.find_last_not_of(" \r") + 1);  // a last cell may be empty
    line.remove_prefix(line.find_first_not_of(' '));
    if (takeSeparator(line) || takeComment(line)) return;
    if (!m_isSeparatorGiven && m_columns == 0) m_separator = traceSeparatorOf(line);
    const TraceCells cells = traceCellsOf(line, m_separator);
    if (m_columns == 0 && !m_hasNames) {
      if (!traceNumberOf(cells[0], m_separator)) return findColumns(cells, line);
      takeFirstColumns(cells, line);
    }
    if (m_columns == 0) m_columns = cells.size();
    if (cells.size() != m_columns || cells.size() < m_named)
      refuse("has " + std::to_string(cells.size()) + " cells, the first line has " +
             std::to_string(std::max(m_columns, m_named)));
    const bool isWanted =
        m_recordingAt == none || m_params.only.empty() || cells[m_recordingAt] == m_params.only;
    if (isWanted) add(cells);
  }

  Trace result() {
    std::vector<Trace::Point>& points = m_trace.points;
    if (points.empty() && !m_params.only.empty())
      throw InputError("has no line whose " + m_params.recording + " is " + shown(m_params.only),
                       "");
    if (points.size() < 2)
      throw InputError("has " + std::to_string(points.size()) +
                           " point(s): a trace has two at least, lines of time, x, y[, z]",
                       "");
    constexpr double shortest = 1e-9;
    if (!(points.back().time >= shortest))
      throw InputError("has no two lines of one recording: no time passes", "");
    return std::move(m_trace);
  }

 private:
  static constexpr std::size_t none = TraceColumns::none;
  static constexpr std::array<const char*, 4> axes{"time", "x", "y", "z"};

  /// Whether the columns are the standard's, so that other names of them may be found.
  [[nodiscard]] bool isStandard() const {
    const TraceParams standard;
    return m_params.time == standard.time && m_params.x == standard.x && m_params.y == standard.y &&
           m_params.z == standard.z;
  }

  /// Takes a spreadsheet's first line, "sep=;".
  bool takeSeparator(std::string_view line) {
    const bool isOne =
        m_line == 1 && line.size() == 5 && lowerCase(std::string(line.substr(0, 4))) == "sep=";
    if (!isOne) return false;
    m_separator = line[4];
    m_isSeparatorGiven = true;
    return true;
  }

  /// Takes a line that begins with # for one of names, if it has them, else for a comment.
  bool takeComment(std::string_view line) {
    if (!line.starts_with('#')) return false;
    if (m_columns > 0 || m_hasNames) return true;
    const char separator = m_isSeparatorGiven ? m_separator : traceSeparatorOf(line);
    TraceCells names = traceCellsOf(line, separator);
    if (std::ranges::find(names, m_params.time) == names.end())
      names = traceCellsOf(line.substr(1), separator);
    const bool hasAll =
        isStandard() ? traceColumnsOf(names).has_value()
                     : indexOf(m_params.time, names) != none && indexOf(m_params.x, names) != none;
    if (!hasAll) return true;
    findColumns(names, line);
    m_columns = 0;  // of lines whose cells may be separated otherwise than a comment's words
    return true;
  }

  /// Sets the columns of a file without names.
  void takeFirstColumns(const TraceCells& cells, std::string_view line) {
    if (!isStandard() || !m_params.recording.empty())
      refuse(shown(line) + " are no names of columns, but the trace's are given");
    const std::optional<TraceColumns> columns = traceColumnsOf(cells, m_separator);
    if (!columns) refuseColumns(line);
    take(*columns);
  }

  void findColumns(const TraceCells& names, std::string_view line) {
    m_hasNames = true;
    m_columns = m_named = names.size();
    if (isStandard()) {
      const std::optional<TraceColumns> columns = traceColumnsOf(names);
      if (!columns) refuseColumns(line);
      take(*columns);
    } else {
      const std::array<std::string_view, 4> wanted{m_params.time, m_params.x, m_params.y,
                                                   m_params.z};
      for (std::size_t k = 0; k < wanted.size(); ++k) {
        m_at.at[k] = indexOf(wanted[k], names);
        const bool mayBeMissing = k == 3 && wanted[k] == "z";
        if (m_at.at[k] == none && !mayBeMissing) refuseName(axes[k], wanted[k], line);
      }
    }
    if (m_params.recording.empty()) return;
    m_recordingAt = indexOf(m_params.recording, names);
    if (m_recordingAt == none) refuseName("recording", m_params.recording, line);
  }

  void take(const TraceColumns& columns) {
    m_at = columns;
    if (!m_at.names.empty()) note("is read with " + m_at.names);
  }

  void note(const std::string& what) {
    if (m_notes != nullptr) m_notes->push_back(what);
  }

  static std::size_t indexOf(std::string_view name, const TraceCells& names) {
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? none : std::size_t(found - names.begin());
  }

  void add(const TraceCells& cells) {
    const double clock = numberIn(cells, 0, 20);
    if (m_trace.points.empty()) guessClock(clock, cells[m_at.at[0]]);
    const double x = metres(cells, 1, m_params.origin.x, m_params.scale.x);
    const double y = metres(cells, 2, m_params.origin.y, m_params.scale.y);
    double z = m_distance;
    if (m_at.at[3] != none) {
      z = metres(cells, 3, m_params.origin.z, m_params.scale.z);
      if (!(z > 0))
        refuse("z " + shown(cells[m_at.at[3]]) + " is not above 0, in front of the panel");
    }
    m_trace.points.push_back({elapsed(cells, clock), {x, y, z}});
  }

  /// Sets the unit of a clock that neither the document nor the names tell.
  void guessClock(double clock, std::string_view cell) {
    if (m_params.timeUnit != 1 || m_at.hasTimeUnit) return;
    m_at.units[0] = traceClockUnitOf(clock);
    if (m_at.units[0] != 1)
      note("says no unit of time: " + std::string(shown(cell)) + " is taken for one of " +
           numberText(m_at.units[0]) + " s since 1970; trace.timeUnit says another");
  }

  /// Returns the time since the first line, without the time between recordings.
  double elapsed(const TraceCells& cells, double clock) {
    const std::string_view recording =
        m_recordingAt == none ? std::string_view() : cells[m_recordingAt];
    const bool isNext = m_trace.points.empty() || recording != m_recording;
    const double unit = m_params.timeUnit * m_at.units[0];
    const double time = clock * unit;
    const std::optional<std::int64_t> ticks = longClockOf(cells[m_at.at[0]]);
    const bool areLong = ticks && m_lastTicks;
    if (!isNext && !(areLong ? *ticks > *m_lastTicks : time > m_last))
      refuse("time " + shown(cells[m_at.at[0]]) + " is not after that of the line before");
    if (!isNext)
      m_elapsed += areLong ? double(std::uint64_t(*ticks) - std::uint64_t(*m_lastTicks)) * unit
                           : time - m_last;
    m_last = time;
    m_lastTicks = ticks;
    m_recording = recording;
    return m_elapsed;
  }

  double metres(const TraceCells& cells, std::size_t axis, double origin, double scale) const {
    constexpr double farthest = 1e4;
    const double place = (numberIn(cells, axis, 12) * m_at.units[axis] - origin) * scale;
    if (!(std::abs(place) <= farthest))
      refuse(std::string(axes[axis]) + " " + shown(cells[m_at.at[axis]]) +
             " is farther than 10000 m");
    return place;
  }

  /// Returns a number of at most 10^`decade`.
  double numberIn(const TraceCells& cells, std::size_t axis, int decade) const {
    const std::string_view cell = cells[m_at.at[axis]];
    const std::optional<double> value = traceNumberOf(cell, m_separator);
    const std::string most = "1e" + std::to_string(decade);
    if (!value || !(std::abs(*value) <= std::pow(10, decade)))
      refuse(std::string(axes[axis]) + " " + shown(cell) + " is not a number from -" + most +
             " to " + most);
    return *value;
  }

  [[noreturn]] void refuseColumns(std::string_view line) const {
    const std::string_view between = m_separator == ';'    ? ", separated by semicolons,"
                                     : m_separator == '\t' ? ", separated by tabs,"
                                     : m_separator == ' '  ? ", separated by spaces,"
                                                           : "";
    refuse(shown(line) + std::string(between) +
           " is not time, x, y or time, x, y, z; \"trace\" in a camera set names other columns");
  }

  [[noreturn]] void refuseName(const char* field, std::string_view name,
                               std::string_view line) const {
    refuse("has no column " + shown(name) + ", which is the trace's " + field + ": " + shown(line));
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError("line " + std::to_string(m_line), why);
  }

  const TraceParams& m_params;
  double m_distance;
  std::vector<std::string>* m_notes;
  std::size_t m_line = 0;
  char m_separator = ',';
  bool m_isSeparatorGiven = false;
  bool m_hasNames = false;
  std::size_t m_columns = 0;  ///< cells of a line
  std::size_t m_named = 0;    ///< columns with names
  TraceColumns m_at;
  std::size_t m_recordingAt = none;
  std::string_view m_recording;
  double m_last = 0;
  std::optional<std::int64_t> m_lastTicks;
  double m_elapsed = 0;
  Trace m_trace;
};

}  // namespace

Trace readTrace(std::string_view text, double distance, const TraceParams& params,
                std::vector<std::string>* notes) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // as spreadsheets begin a file
  TraceReader reader(distance, params, notes);
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    reader.read(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reader.result();
}

}  // namespace hogelscope
