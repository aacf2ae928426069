// SPDX-License-Identifier: BSD-3-Clause
#include "page/latex.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "page/html.h"

namespace hogelscope {

namespace {

/// Returns the text for LaTeX: special characters escaped, dashes and hyphens in ASCII.
std::string texText(const std::string& text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 14> replaced{
      {{"\\", "\\textbackslash{}"},
       {"{", "\\{"},
       {"}", "\\}"},
       {"&", "\\&"},
       {"%", "\\%"},
       {"$", "\\$"},
       {"#", "\\#"},
       {"_", "\\_"},
       {"~", "\\textasciitilde{}"},
       {"^", "\\textasciicircum{}"},
       {"–", "--"},
       {"\u2011", "-"},
       {"<", "\\textless{}"},
       {">", "\\textgreater{}"}}};
  std::string tex;
  for (std::size_t at = 0; at < text.size();) {
    const auto found = std::ranges::find_if(replaced, [&](const auto& one) {
      return std::string_view(text).substr(at).starts_with(one.first);
    });
    tex += found == replaced.end() ? std::string_view(text).substr(at, 1) : found->second;
    at += found == replaced.end() ? 1 : found->first.size();
  }
  return tex;
}

std::string lineOf(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : " & ") + texText(cell);
  return line + " \\\\\n";
}

bool isNumber(const std::string& cell) {
  return !cell.empty() && std::string_view("0123456789-").find(cell[0]) != std::string_view::npos;
}

}  // namespace

std::string latexTable(const std::vector<std::string>& heads,
                       const std::vector<std::vector<std::string>>& rows) {
  std::string columns;
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const bool isRight =
        k > 0 && std::ranges::any_of(rows, [k](const auto& row) { return isNumber(row[k]); });
    columns += isRight ? "r" : "l";
  }
  std::string tex = "\\begin{tabular}{" + columns + "}\n\\hline\n" + lineOf(heads) + "\\hline\n";
  for (const std::vector<std::string>& row : rows) tex += lineOf(row);
  tex += "\\hline\n\\end{tabular}\n";
  return "<details><summary>As LaTeX</summary><pre>" + escaped(tex) + "</pre></details>\n";
}

}  // namespace hogelscope
