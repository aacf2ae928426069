// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/trace_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string_view> cellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t comma = 0; comma != std::string_view::npos;) {
    const std::size_t quote = line.starts_with('"') ? line.find('"', 1) : 0;
    comma = line.find(',', quote);
    const std::string_view cell = trimmed(line.substr(0, comma));
    const bool isQuoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
    cells.push_back(isQuoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell);
    line.remove_prefix(comma == std::string_view::npos ? line.size() : comma + 1);
  }
  return cells;
}

/// Formats a cell for an error line: short, and harmless to a terminal.
std::string shown(std::string_view cell) {
  constexpr std::size_t longest = 40;
  std::string text(cell.substr(0, longest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  return "\"" + text + (cell.size() > longest ? "…\"" : "\"");
}

/// Reads a trace line by line.
class TraceReader {
 public:
  TraceReader(double distance, const TraceParams& params) : m_params(params), m_distance(distance) {
    m_trace.holds = params.holds;
  }

  void read(std::string_view line) {
    ++m_line;
    line = trimmed(line);
    if (line.empty()) return;
    const std::vector<std::string_view> cells = cellsOf(line);
    if (m_columns == 0) {
      m_columns = cells.size();
      if (!numberOf(cells[0])) return findColumns(cells, line);
      takeFirstColumns(line);
    }
    if (cells.size() != m_columns)
      refuse("has " + std::to_string(cells.size()) + " cells, the first line has " +
             std::to_string(m_columns));
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
  static constexpr std::size_t none = std::size_t(-1);
  static constexpr std::array<const char*, 4> axes{"time", "x", "y", "z"};

  /// Sets the columns of a file without names: time, x, y[, z].
  void takeFirstColumns(std::string_view line) {
    const TraceParams standard;
    const bool isNamed = m_params.time != standard.time || m_params.x != standard.x ||
                         m_params.y != standard.y || m_params.z != standard.z ||
                         !m_params.recording.empty();
    if (isNamed) refuse(shown(line) + " are no names of columns, but the trace's are given");
    if (m_columns < 3 || m_columns > 4) refuseColumns(line);
    m_at = {0, 1, 2, m_columns == 4 ? 3 : none};
  }

  void findColumns(const std::vector<std::string_view>& names, std::string_view line) {
    const std::array<std::string_view, 4> wanted{m_params.time, m_params.x, m_params.y, m_params.z};
    const bool isStandard = wanted == std::array<std::string_view, 4>{"time", "x", "y", "z"};
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      m_at[k] = indexOf(wanted[k], names);
      const bool mayBeMissing = k == 3 && wanted[k] == "z";
      if (m_at[k] != none || mayBeMissing) continue;
      if (isStandard) refuseColumns(line);
      refuseName(axes[k], wanted[k], line);
    }
    if (m_params.recording.empty()) return;
    m_recordingAt = indexOf(m_params.recording, names);
    if (m_recordingAt == none) refuseName("recording", m_params.recording, line);
  }

  static std::size_t indexOf(std::string_view name, const std::vector<std::string_view>& names) {
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? none : std::size_t(found - names.begin());
  }

  void add(const std::vector<std::string_view>& cells) {
    const double time = numberIn(cells, 0, 18) * m_params.timeUnit;
    const double x = metres(cells, 1, m_params.origin.x, m_params.scale.x);
    const double y = metres(cells, 2, m_params.origin.y, m_params.scale.y);
    double z = m_distance;
    if (m_at[3] != none) {
      z = metres(cells, 3, m_params.origin.z, m_params.scale.z);
      if (!(z > 0)) refuse("z " + shown(cells[m_at[3]]) + " is not above 0, in front of the panel");
    }
    m_trace.points.push_back({elapsed(cells, time), {x, y, z}});
  }

  /// Returns the time since the first line, without the time between recordings.
  double elapsed(const std::vector<std::string_view>& cells, double time) {
    const std::string_view recording =
        m_recordingAt == none ? std::string_view() : cells[m_recordingAt];
    const bool isNext = m_trace.points.empty() || recording != m_recording;
    if (!isNext && !(time > m_last))
      refuse("time " + shown(cells[m_at[0]]) + " is not after that of the line before");
    if (!isNext) m_elapsed += time - m_last;
    m_last = time;
    m_recording = recording;
    return m_elapsed;
  }

  double metres(const std::vector<std::string_view>& cells, std::size_t axis, double origin,
                double scale) const {
    constexpr double farthest = 1e4;
    const double place = (numberIn(cells, axis, 12) - origin) * scale;
    if (!(std::abs(place) <= farthest))
      refuse(std::string(axes[axis]) + " " + shown(cells[m_at[axis]]) + " is farther than 10000 m");
    return place;
  }

  /// Returns a number of at most 10^`decade`.
  double numberIn(const std::vector<std::string_view>& cells, std::size_t axis, int decade) const {
    const std::string_view cell = cells[m_at[axis]];
    const std::optional<double> value = numberOf(cell);
    const std::string most = "1e" + std::to_string(decade);
    if (!value || !(std::abs(*value) <= std::pow(10, decade)))
      refuse(std::string(axes[axis]) + " " + shown(cell) + " is not a number from -" + most +
             " to " + most);
    return *value;
  }

  [[noreturn]] void refuseColumns(std::string_view line) const {
    refuse(shown(line) +
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
  std::size_t m_line = 0;
  std::size_t m_columns = 0;
  std::array<std::size_t, 4> m_at{};  ///< the columns of time, x, y, z
  std::size_t m_recordingAt = none;
  std::string_view m_recording;
  double m_last = 0;
  double m_elapsed = 0;
  Trace m_trace;
};

}  // namespace

Trace readTrace(std::string_view text, double distance, const TraceParams& params) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // as spreadsheets begin a file
  TraceReader reader(distance, params);
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    reader.read(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reader.result();
}

}  // namespace hogelscope
