// SPDX-License-Identifier: BSD-3-Clause
// A measured hogel lens: a table of positions in the angular field and the angles of their light,
// interpolated by the monotone cubics of Fritsch and Butland, "A method for constructing local
// monotone piecewise cubic interpolants", SIAM J. Sci. Stat. Comput. 5 (1984).
#include <hogelscope/plugin.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace {

using namespace hogelscope;

constexpr double perDegree = std::numbers::pi / 180;
constexpr std::size_t mostRows = 10000;
constexpr std::uintmax_t mostBytes = 1000000;

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw std::runtime_error(file + ": " + what);
}

std::string text(double number) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.6g", number);
  return digits.data();
}

/// A position in the angular field, −1/2 … 1/2, and the angle of its light in degrees.
struct Row {
  double direction = 0;
  double angle = 0;
};

/// Parses "DIRECTION,ANGLE". Returns whether these are two numbers.
bool read(std::string_view line, Row& row) {
  const auto number = [](std::string_view digits, double& value) {
    const auto isSpace = [](char c) { return c == ' ' || c == '\t'; };
    while (!digits.empty() && isSpace(digits.front())) digits.remove_prefix(1);
    while (!digits.empty() && isSpace(digits.back())) digits.remove_suffix(1);
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    return error == std::errc() && stop == end && std::isfinite(value);
  };
  const std::size_t comma = line.find(',');
  return comma != std::string_view::npos && number(line.substr(0, comma), row.direction) &&
         number(line.substr(comma + 1), row.angle);
}

void check(const std::string& file, const std::vector<Row>& rows) {
  if (rows.size() < 2)
    fail(file, "has fewer than two rows: measure the ends of the field at least");
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (!(rows[k].direction > rows[k - 1].direction) || !(rows[k].angle > rows[k - 1].angle))
      fail(file, "row " + std::to_string(k + 1) +
                     " does not grow: sort the table; both columns grow from row to row");
  if (rows.front().direction != -0.5 || rows.back().direction != 0.5)
    fail(file, "its directions reach from " + text(rows.front().direction) + " to " +
                   text(rows.back().direction) + ": give the field's ends, -0.5 and 0.5");
  if (!(rows.front().angle > -90) || !(rows.back().angle < 90))
    fail(file, "has an angle of 90° or more: no such light leaves the panel");
}

/// Reads a CSV file with the columns direction,angle.
std::vector<Row> readTable(const std::string& file) {
  std::error_code error;
  const char* const unreadable = "cannot be read: give a CSV file with the columns direction,angle";
  if (!std::filesystem::is_regular_file(file, error)) fail(file, unreadable);  // a pipe would block
  if (!(std::filesystem::file_size(file, error) <= mostBytes))
    fail(file, "has more than 1 MB: give fewer rows");
  std::ifstream opened(file);
  if (!opened) fail(file, unreadable);
  std::vector<Row> rows;
  std::string line;
  for (std::size_t at = 1; std::getline(opened, line) && rows.size() <= mostRows; ++at) {
    if (line.ends_with('\r')) line.pop_back();
    if (at == 1 && line != "direction,angle")
      fail(file, "begins with another line than its columns, direction,angle");
    if (at == 1 || line.empty()) continue;
    if (!read(line, rows.emplace_back()))
      fail(file, "line " + std::to_string(at) + " is not two numbers: direction,angle");
  }
  if (rows.size() > mostRows) fail(file, "has more than 10000 rows: give fewer");
  check(file, rows);
  return rows;
}

/// The field as a function of the angle: increasing cubics between the rows, lines beyond them.
class Curve {
 public:
  Curve() = default;
  explicit Curve(std::vector<Row> rows) : m_rows(std::move(rows)), m_rates(m_rows.size()) {
    const std::size_t last = m_rows.size() - 1;
    for (std::size_t k = 1; k < last; ++k) {
      const double before = width(k - 1);
      const double after = width(k);
      m_rates[k] = 3 * (before + after) /
                   ((2 * after + before) / chord(k - 1) + (after + 2 * before) / chord(k));
    }
    m_rates.front() = last == 1 ? chord(0) : endRate(0, 1);
    m_rates.back() = last == 1 ? chord(0) : endRate(last - 1, last - 2);
  }

  [[nodiscard]] double directionOf(double angle) const {
    const auto& [first, last] = ends();
    if (!(angle > first.angle)) return first.direction + chord(0) * (angle - first.angle);
    if (!(angle < last.angle))
      return last.direction + chord(m_rows.size() - 2) * (angle - last.angle);
    return cubic(pieceOf(angle, &Row::angle), angle);
  }

  [[nodiscard]] double angleOf(double direction) const {
    const auto& [first, last] = ends();
    if (!(direction > first.direction))
      return first.angle + (direction - first.direction) / chord(0);
    if (!(direction < last.direction))
      return last.angle + (direction - last.direction) / chord(m_rows.size() - 2);
    const std::size_t k = pieceOf(direction, &Row::direction);
    double low = m_rows[k].angle;
    double high = m_rows[k + 1].angle;
    double middle = low + (direction - m_rows[k].direction) / chord(k);
    // Alternates false position, which converges fast, with bisection, which guarantees the end.
    for (int step = 0; step < 200 && low < middle && middle < high; ++step) {
      const double there = cubic(k, middle);
      (there < direction ? low : high) = middle;
      const double from = cubic(k, low);
      const double to = cubic(k, high);
      const double next = step % 2 == 0 && to > from
                              ? low + (high - low) * (direction - from) / (to - from)
                              : low + (high - low) / 2;
      if (next == middle) break;
      middle = next;
    }
    return std::clamp(middle, low, high);
  }

 private:
  struct Ends {
    const Row& first;
    const Row& last;
  };
  [[nodiscard]] Ends ends() const { return {m_rows.front(), m_rows.back()}; }
  [[nodiscard]] double width(std::size_t k) const { return m_rows[k + 1].angle - m_rows[k].angle; }
  [[nodiscard]] double chord(std::size_t k) const {
    return (m_rows[k + 1].direction - m_rows[k].direction) / width(k);
  }
  /// Returns the rate of the parabola through the end's three points, limited to increasing curves.
  [[nodiscard]] double endRate(std::size_t piece, std::size_t next) const {
    const double rate =
        ((2 * width(piece) + width(next)) * chord(piece) - width(piece) * chord(next)) /
        (width(piece) + width(next));
    return std::clamp(rate, 0.0, 3 * chord(piece));
  }
  [[nodiscard]] std::size_t pieceOf(double value, double Row::*column) const {
    const auto after = std::ranges::upper_bound(m_rows, value, {}, column);
    return std::size_t(after - m_rows.begin()) - 1;
  }
  [[nodiscard]] double cubic(std::size_t k, double angle) const {
    const double h = width(k);
    const double t = (angle - m_rows[k].angle) / h;
    const double rise = chord(k) * h;
    const double a = m_rates[k] * h - rise;
    const double b = m_rates[k + 1] * h - rise;
    return m_rows[k].direction + t * (rise + (1 - t) * (a * (1 - t) - b * t));
  }

  std::vector<Row> m_rows;
  std::vector<double> m_rates;  ///< of the direction, per degree, at each row
};

class MeasuredLens final : public plugin::HogelLens {
 public:
  void describe(ParameterVisitor& v) override {
    v.group("measured-lens", "A hogel lens that was measured.");
    v.field(
        "file", m_file,
        "CSV with the columns direction (-0.5 to 0.5) and angle (°, to the right and up), across "
        "and down; empty: evenly in slope.");
    v.field("fileDown", m_fileDown, "Another table for down, of lenses that differ there.");
  }

  void open(std::int32_t axis, double fov, const plugin::Place& /*place*/) override {
    const std::string& file = axis == 1 && !m_fileDown.empty() ? m_fileDown : m_file;
    m_width = file.empty() ? 2 * std::tan(fov * perDegree / 2) : 0;
    if (file.empty()) return;
    const std::vector<Row> rows = readTable(file);
    const double field = rows.back().angle - rows.front().angle;
    if (constexpr double allowed = 0.05; std::abs(field - fov) > allowed)
      fail(file, "its angles span " + text(field) + "°: set display.fov to this " +
                     (axis == 0 ? "across" : "down") + ", not " + text(fov));
    m_curve = Curve(rows);
  }

  [[nodiscard]] double directionOf(double slope) const override {
    return m_width > 0 ? slope / m_width : m_curve.directionOf(std::atan(slope) / perDegree);
  }

  [[nodiscard]] double slopeOf(double direction) const override {
    constexpr double most = 89.9999;
    return m_width > 0 ? direction * m_width
                       : std::tan(std::clamp(m_curve.angleOf(direction), -most, most) * perDegree);
  }

 private:
  std::string m_file;
  std::string m_fileDown;
  double m_width = 0;  ///< the field's width in slopes, without a table
  Curve m_curve;
};

plugin::HogelLens* makeLens() {
  return new MeasuredLens;
}

}  // namespace

HOGELSCOPE_PLUGIN("measured-lens", "1.0", nullptr, makeLens, nullptr);
