// SPDX-License-Identifier: BSD-3-Clause
#include "page/html.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

namespace hogelscope {

namespace {

using Replacement = std::pair<std::string_view, std::string_view>;

std::string replaced(std::string_view text, std::span<const Replacement> all) {
  std::string out;
  while (!text.empty()) {
    const auto found = std::ranges::find_if(
        all, [&](const Replacement& one) { return text.starts_with(one.first); });
    out += found == all.end() ? text.substr(0, 1) : found->second;
    text.remove_prefix(found == all.end() ? 1 : found->first.size());
  }
  return out;
}

std::string escapedLine(const std::string& text) {
  static constexpr std::array<Replacement, 4> entities{
      {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}}};
  return replaced(printable(text), entities);
}

/// Returns the text for LaTeX: special characters escaped, dashes and hyphens in ASCII.
std::string texText(const std::string& text) {
  static constexpr std::array<Replacement, 16> commands{{{"\\", "\\textbackslash{}"},
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
                                                         {"−", "$-$"},
                                                         {"…", "\\ldots{}"},
                                                         {"<", "\\textless{}"},
                                                         {">", "\\textgreater{}"}}};
  return replaced(text, commands);
}

std::string lineOf(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells)
    line += (line.empty() ? "" : " & ") + texText(withMinus(cell));
  return line + " \\\\\n";
}

bool isNumber(const std::string& cell) {
  return !cell.empty() && std::string_view("0123456789-").find(cell[0]) != std::string_view::npos;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (std::size_t at = 0;; ++at) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out += escapedLine(text.substr(at, end - at));
    if (end == text.size()) return out;
    out += '\n';
    at = end;
  }
}

std::string base64(const std::string& bytes) {
  constexpr const char* alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = at; k < at + 3; ++k)
      bits = bits << 8U | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += at + k <= bytes.size() ? alphabet[bits >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

std::string imageTag(const std::string& png, const std::string& text) {
  return "<img alt=\"" + escaped(text) + "\" src=\"data:image/png;base64," + base64(png) + "\"/>";
}

std::string latexTable(const Table& table) {
  const auto rows = std::span(table).subspan(1);
  std::string columns;
  for (std::size_t k = 0; k < table[0].size(); ++k) {
    const bool isRight =
        k > 0 && std::ranges::any_of(rows, [k](const auto& row) { return isNumber(row[k]); });
    columns += isRight ? "r" : "l";
  }
  std::string tex = "\\begin{tabular}{" + columns + "}\n\\hline\n" + lineOf(table[0]) + "\\hline\n";
  for (const std::vector<std::string>& row : rows) tex += lineOf(row);
  return tex + "\\hline\n\\end{tabular}\n";
}

std::string latexPart(const std::string& tex) {
  return "<details><summary>As LaTeX</summary><pre>" + escaped(tex) + "</pre></details>\n";
}

std::string pageOf(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
         std::string(pagePolicy) +
         "\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>" +
         escaped(title) + "</title>\n<style>" + pageStyle + "</style></head><body>\n" + body +
         "<script>" + pageScript + "</script>\n</body></html>\n";
}

namespace {

/// Returns the height of an `<svg>` over its width, by its viewBox.
double aspectOf(const std::string& svg) {
  constexpr std::string_view box = "viewBox=\"0 0 ";
  double width = 1;
  double height = 1;
  if (const std::size_t at = svg.find(box); at != std::string::npos) {
    std::istringstream numbers(svg.substr(at + box.size(), 40));
    numbers >> width >> height;
  }
  return height / width;
}

}  // namespace

std::string svgFile(const std::string& svg, double width) {
  constexpr std::string_view tag = "<svg ";
  const std::size_t at = svg.find('>') + 1;
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + numberText(width) +
         "mm\" height=\"" + numberText(fourDigits(width * aspectOf(svg))) + "mm\" " +
         svg.substr(tag.size(), at - tag.size()) + "<style>" + plotStyle + "</style>" +
         svg.substr(at);
}

}  // namespace hogelscope
