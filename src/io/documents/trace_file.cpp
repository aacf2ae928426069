// SPDX-License-Identifier: BSD-3-Clause
// Viewers' traces: CSV of time and position.
#include "io/documents/trace_file.h"

#include <array>
#include <charconv>
#include <optional>

#include "core/base/error.h"

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
    comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma == std::string_view::npos ? line.size() : comma + 1);
  }
  return cells;
}

std::optional<double> numberOf(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Formats a cell for an error line: short, and harmless to a terminal.
std::string shown(std::string_view cell) {
  constexpr std::size_t longest = 40;
  std::string text(cell.substr(0, longest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  return "\"" + text + (cell.size() > longest ? "…\"" : "\"");
}

/// The lines of a trace, one after the other.
class TraceReader {
 public:
  explicit TraceReader(double distance) : m_distance(distance) {}

  void read(std::string_view line) {
    ++m_line;
    line = trimmed(line);
    if (line.empty()) return;
    const std::vector<std::string_view> cells = cellsOf(line);
    if (m_columns == 0) {
      m_columns = cells.size();
      if (m_columns < 3 || m_columns > 4)
        refuse(shown(line) + " is not time, x, y or time, x, y, z");
      if (!numberOf(cells[0])) return checkNames(cells, line);
    }
    if (cells.size() != m_columns)
      refuse("has " + std::to_string(cells.size()) + " cells, the first line has " +
             std::to_string(m_columns));
    add(cells);
  }

  Trace result() {
    if (m_trace.points.size() < 2)
      throw InputError("has " + std::to_string(m_trace.points.size()) +
                           " point(s): a trace has two at least, lines of time, x, y[, z]",
                       "");
    return std::move(m_trace);
  }

 private:
  static constexpr std::array<const char*, 4> names{"time", "x", "y", "z"};

  void checkNames(const std::vector<std::string_view>& cells, std::string_view line) const {
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (cells[k] != names[k]) refuse(shown(line) + " is not time, x, y or time, x, y, z");
  }

  void add(const std::vector<std::string_view>& cells) {
    std::array<double, 4> values{0, 0, 0, m_distance};
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const double farthest = k == 0 ? 1e12 : 1e4;
      const std::optional<double> value = numberOf(cells[k]);
      if (!value || !(*value >= -farthest && *value <= farthest))
        refuse(std::string(names[k]) + " " + shown(cells[k]) + " is not a number from " +
               (k == 0 ? "-1e12 to 1e12 s" : "-10000 to 10000 m"));
      values[k] = *value;
    }
    if (!(values[3] > 0)) refuse("z " + shown(cells[3]) + " is not above 0, in front of the panel");
    if (!m_trace.points.empty() && !(values[0] > m_trace.points.back().time))
      refuse("time " + shown(cells[0]) + " is not after that of the line before");
    m_trace.points.push_back({values[0], {values[1], values[2], values[3]}});
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError("line " + std::to_string(m_line), why);
  }

  double m_distance;
  std::size_t m_line = 0;
  std::size_t m_columns = 0;
  Trace m_trace;
};

}  // namespace

Trace readTrace(std::string_view text, double distance) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // as spreadsheets begin a file
  TraceReader reader(distance);
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    reader.read(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reader.result();
}

}  // namespace hogelscope
