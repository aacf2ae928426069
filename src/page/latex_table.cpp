// SPDX-License-Identifier: BSD-3-Clause
#include "page/latex_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

namespace hogelscope {

namespace {

/// How a character is written, and its width in Computer Modern of 10 points.
struct Written {
  std::string_view character;
  std::string_view tex;
  double width;
};

constexpr std::array written{Written{"\\", "\\textbackslash{}", 5},
                             Written{"{", "\\{", 5},
                             Written{"}", "\\}", 5},
                             Written{"&", "\\&", 7.8},
                             Written{"%", "\\%", 8.4},
                             Written{"$", "\\$", 5},
                             Written{"#", "\\#", 8.4},
                             Written{"_", "\\_", 3.7},
                             Written{"~", "\\textasciitilde{}", 5},
                             Written{"^", "\\textasciicircum{}", 5},
                             Written{"–", "--", 5},
                             Written{"\u2011", "-", 3.4},
                             Written{"−", "$-$", 7.8},
                             Written{"…", "\\ldots{}", 11.7},
                             Written{"<", "\\textless{}", 7.8},
                             Written{">", "\\textgreater{}", 7.8}};

/// Widths of a … z and A … Z.
constexpr std::array small{5.0, 5.6, 4.5, 5.6, 4.5, 3.1, 5.0, 5.6, 2.8, 3.1, 5.3, 2.8, 8.4,
                           5.6, 5.0, 5.6, 5.3, 4.0, 4.0, 3.9, 5.6, 5.3, 7.3, 5.3, 5.3, 4.5};
constexpr std::array large{7.5, 7.1, 7.3, 7.7, 6.9, 6.6, 7.9, 7.5, 3.7, 5.2,  7.8, 6.3, 9.2,
                           7.5, 7.8, 6.9, 7.8, 7.4, 5.6, 7.3, 7.5, 7.5, 10.3, 7.5, 7.5, 6.2};

double widthOf(std::string_view character) {
  const auto found = std::ranges::find(written, character, &Written::character);
  if (found != written.end()) return found->width;
  if (character.size() > 1) return 7.8;  // not ASCII
  const auto letter = static_cast<unsigned char>(character[0]);
  if (std::islower(letter) != 0) return small[std::size_t(letter - 'a')];
  if (std::isupper(letter) != 0) return large[std::size_t(letter - 'A')];
  if (std::isdigit(letter) != 0) return 5;
  return std::string_view("(/)-").find(character) != std::string_view::npos   ? 5
         : std::string_view("=+*@").find(character) != std::string_view::npos ? 7.8
                                                                              : 3.4;
}

/// Returns the width of a text in points: of 8 points, whose letters are 0.85 as wide as those of
/// 10, and 2 % for kerning that is not there.
double texWidth(const std::string& text) {
  double width = 0;
  for (const std::string& character : charactersOf(withMinus(text))) width += widthOf(character);
  return 0.87 * width;
}

std::string texText(const std::string& text) {
  std::string out;
  for (const std::string& character : charactersOf(withMinus(text))) {
    const auto found = std::ranges::find(written, character, &Written::character);
    out += found == written.end() ? character : std::string(found->tex);
  }
  return out;
}

bool isNumber(const std::string& cell) {
  return cell.starts_with("−") ||
         (!cell.empty() && std::string_view("0123456789-").find(cell[0]) != std::string_view::npos);
}

using Lines = std::vector<std::string>;

/// Returns the words of a text in lines of at most this width, or one word each.
Lines wrapped(const std::string& text, double width) {
  Lines lines;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (lines.empty() || texWidth(lines.back() + " " + word) > width)
      lines.push_back(word);
    else
      lines.back() += " " + word;
    at = end + 1;
  }
  return lines.empty() ? Lines{""} : lines;
}

/// Returns a value and its range in two lines.
Lines rangeBelow(const std::string& cell) {
  const std::size_t at = cell.ends_with(')') ? cell.find(" (") : std::string::npos;
  return at == std::string::npos ? Lines{cell} : Lines{cell.substr(0, at), cell.substr(at + 1)};
}

/// Returns a text of at most this width, without its middle if it is wider.
std::string withoutMiddle(const std::string& text, double width) {
  std::vector<std::string> letters = charactersOf(text);
  const auto join = [](auto from, auto to) { return std::accumulate(from, to, std::string()); };
  std::string shown = text;
  for (auto half = std::ptrdiff_t(letters.size() / 2); texWidth(shown) > width && half > 1; --half)
    shown = join(letters.begin(), letters.begin() + half) + "…" +
            join(letters.end() - half, letters.end());
  return shown;
}

/// A column of a table: its cells in lines, the head first.
struct Column {
  std::vector<Lines> cells;
  bool isRight = false;

  [[nodiscard]] double bodyWidth() const {
    double width = 0;
    for (const Lines& lines : std::span(cells).subspan(1))
      for (const std::string& line : lines) width = std::max(width, texWidth(line));
    return width;
  }
  [[nodiscard]] double width() const {
    double width = bodyWidth();
    for (const std::string& line : cells[0]) width = std::max(width, texWidth(line));
    return width;
  }
  void wrapHead(const std::string& head) {
    double widest = bodyWidth();
    for (const std::string& word : wrapped(head, 0)) widest = std::max(widest, texWidth(word));
    cells[0] = wrapped(head, widest);
  }
};

constexpr double columnGap = 6;  ///< between columns, 2 \tabcolsep

double widthOf(std::span<const Column> columns) {
  double width = -columnGap;
  for (const Column& column : columns) width += column.width() + columnGap;
  return width;
}

std::vector<Column> columnsOf(const Table& table) {
  std::vector<Column> columns(table[0].size());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    for (const std::vector<std::string>& row : table) columns[k].cells.push_back({row[k]});
    columns[k].isRight =
        k > 0 && std::ranges::any_of(std::span(table).subspan(1),
                                     [k](const auto& row) { return isNumber(row[k]); });
  }
  return columns;
}

/// Returns the number of columns that name a row: the text columns at the beginning.
std::size_t labelsOf(const std::vector<Column>& columns) {
  std::size_t labels = 1;
  while (labels + 1 < columns.size() && !columns[labels].isRight) ++labels;
  return labels;
}

/// Breaks heads, ranges and labels as far as needed.
void narrow(std::vector<Column>& columns, const Table& table, double width) {
  const auto wrapHeads = [&] {
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].wrapHead(table[0][k]);
  };
  if (widthOf(columns) <= width) return;
  wrapHeads();
  if (widthOf(columns) <= width) return;
  const std::size_t labels = labelsOf(columns);
  double widest = 0;
  for (std::size_t k = labels; k < columns.size(); ++k) {
    for (std::size_t row = 1; row < table.size(); ++row)
      columns[k].cells[row] = rangeBelow(table[row][k]);
    columns[k].wrapHead(table[0][k]);
    widest = std::max(widest, columns[k].width());
  }
  // The widest names give way.
  for (std::size_t more = 0; more < labels; ++more) {
    const auto names = std::span(columns).first(labels);
    const double excess = widthOf(names) + columnGap + widest - width;
    if (excess <= 0) return;
    const auto k = std::size_t(
        std::ranges::max_element(names, {}, [](const Column& name) { return name.width(); }) -
        names.begin());
    const double room = std::max(names[k].width() - excess, width / 8);
    for (std::size_t row = 0; row < table.size(); ++row) {
      names[k].cells[row] = wrapped(table[row][k], room);
      for (std::string& line : names[k].cells[row]) line = withoutMiddle(line, room);
    }
  }
}

std::string tabularOf(const std::vector<const Column*>& columns) {
  std::string kinds;
  for (const Column* const column : columns) kinds += column->isRight ? "r" : "l";
  std::string tex = "\\begin{tabular}{@{}" + kinds + "@{}}\n\\hline\n";
  for (std::size_t row = 0; row < columns[0]->cells.size(); ++row) {
    std::size_t lines = 1;
    for (const Column* const column : columns) lines = std::max(lines, column->cells[row].size());
    for (std::size_t line = 0; line < lines; ++line) {
      std::string text;
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const Lines& cell = columns[k]->cells[row];
        text += (k == 0 ? "" : " & ") + (line < cell.size() ? texText(cell[line]) : "");
      }
      tex += text + " \\\\\n";
    }
    if (row == 0) tex += "\\hline\n";
  }
  return tex + "\\hline\n\\end{tabular}";
}

}  // namespace

std::string latexTable(const Table& table, double width) {
  std::vector<Column> columns = columnsOf(table);
  narrow(columns, table, width);
  std::string tex = "{\\footnotesize\\setlength{\\tabcolsep}{3pt}%\n";
  const std::size_t labels = labelsOf(columns);
  std::size_t next = labels;
  do {
    std::vector<const Column*> part;
    double used = -columnGap;
    for (std::size_t k = 0; k < labels; ++k) {
      part.push_back(&columns[k]);
      used += columnGap + columns[k].width();
    }
    for (; next < columns.size(); ++next) {
      used += columnGap + columns[next].width();
      if (used > width && part.size() > labels) break;
      part.push_back(&columns[next]);
    }
    tex += tabularOf(part) + (next < columns.size() ? "\\par\\smallskip\n" : "}\n");
  } while (next < columns.size());
  return tex;
}

}  // namespace hogelscope
