// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace hogelscope {

namespace {

/// Whether a spreadsheet would read the text as a formula. Numbers are none, even with a sign.
bool isFormula(const std::string& text) {
  static const std::array<std::string_view, 11> beginnings{"=",  "+",  "-",  "@",  "\t", "\r",
                                                           "\n", "＝", "＋", "－", "＠"};
  if (numberOf(text)) return false;
  return std::ranges::any_of(beginnings,
                             [&text](std::string_view sign) { return text.starts_with(sign); });
}

std::string csvCell(const std::string& text) {
  std::string harmless = isFormula(text) ? "'" + text : text;
  if (harmless.find_first_of(",\"\r\n") == std::string::npos) return harmless;
  std::string cell = "\"";
  for (const char c : harmless) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

/// Returns the number of continuation bytes after a first byte, and its bits; none for other bytes.
std::optional<std::pair<std::size_t, char32_t>> leadOf(unsigned char byte) {
  if (byte < 0x80) return std::pair{std::size_t(0), char32_t(byte)};
  if (byte >= 0xC2 && byte < 0xE0) return std::pair{std::size_t(1), char32_t(byte & 0x1FU)};
  if (byte >= 0xE0 && byte < 0xF0) return std::pair{std::size_t(2), char32_t(byte & 0x0FU)};
  if (byte >= 0xF0 && byte < 0xF5) return std::pair{std::size_t(3), char32_t(byte & 0x07U)};
  return std::nullopt;
}

/// Returns an escape such as "\x1b" or "\u202e": a letter for the number of digits, and the lowest
/// digits.
std::string escape(char letter, int digits, char32_t value) {
  std::string text{'\\', letter};
  for (int k = digits - 1; k >= 0; --k) text += "0123456789abcdef"[value >> unsigned(4 * k) & 15U];
  return text;
}

}  // namespace

std::string pairText(long long across, long long down) {
  return std::to_string(across) + "×" + std::to_string(down);
}

std::string lowerCase(std::string text) {
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'Z') letter = char(letter - 'A' + 'a');
  return text;
}

std::string formLabel(std::string_view name) {
  std::string label(name);
  const auto lower = [](unsigned char c) { return char(std::tolower(c)); };
  const auto upper = [](unsigned char c) { return char(std::toupper(c)); };
  if (name.find_first_of("aeiouyAEIOUY") == std::string_view::npos) {
    if (name.size() > 2) std::ranges::transform(label, label.begin(), upper);
    return label;
  }
  for (std::size_t k = label.size() - 1; k > 0; --k)
    if (std::islower(static_cast<unsigned char>(label[k - 1])) != 0 &&
        std::isupper(static_cast<unsigned char>(label[k])) != 0)
      label.insert(k, 1, ' ');
  std::ranges::replace(label, '-', ' ');
  std::ranges::transform(label, label.begin(), lower);
  label[0] = upper(static_cast<unsigned char>(label[0]));
  return label;
}

std::string numberCell(double value) {
  return std::isnan(value) ? std::string() : numberText(value);
}

std::string csvText(const Table& table) {
  std::string text;
  for (const std::vector<std::string>& row : table)
    for (const std::string& cell : row) text += csvCell(cell) + (&cell == &row.back() ? "\n" : ",");
  return text;
}

Table csvRows(std::string_view text) {
  Table rows;
  bool isQuoted = false;
  bool begins = true;  // a line
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (begins) rows.push_back({""});
    begins = false;
    std::string& cell = rows.back().back();
    if (c == '"') {
      const bool isPair = isQuoted && k + 1 < text.size() && text[k + 1] == '"';
      if (isPair)
        cell += text[k++];
      else
        isQuoted = !isQuoted;
    } else if (isQuoted || (c != ',' && c != '\n' && c != '\r')) {
      cell += c;
    } else if (c == ',') {
      rows.back().emplace_back();
    } else {
      begins = c == '\n';
    }
  }
  for (std::vector<std::string>& row : rows)
    for (std::string& cell : row)
      if (cell.starts_with('\'') && isFormula(cell.substr(1))) cell.erase(0, 1);
  return rows;
}

std::string numberText(double value) {
  if (std::isnan(value)) return "nan";  // to_chars may write -nan
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::optional<double> numberOf(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return stop == end && error == std::errc() ? std::optional(value) : std::nullopt;
}

double fourDigits(double value) {
  std::array<char, 32> text{};
  char* const end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4)
          .ptr;
  double number = value;
  std::from_chars(text.data(), end, number);
  return number;
}

std::string rounded(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return "identical";
  std::array<char, 400> text{};  // at most 309 digits before the point
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits)
          .ptr;
  std::string number(text.data(), end);
  if (number.find_first_not_of("-0.") == std::string::npos && number[0] == '-') number.erase(0, 1);
  return number;
}

std::string withMinus(const std::string& text) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  std::string result;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool begins = k == 0 || text[k - 1] == ' ' || text[k - 1] == '(' ||
                        (text[k - 1] == 'e' && k > 1 && isDigit(text[k - 2]));
    if (text[k] == '-' && begins && k + 1 < text.size() && isDigit(text[k + 1]))
      result += "−";
    else
      result += text[k];
  }
  return result;
}

std::string bytesText(std::size_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " bytes";
  const auto tenths = [bytes](double unit) { return std::round(10 * double(bytes) / unit) / 10; };
  for (const auto& [unit, name] : {std::pair(1e3, " kB"), std::pair(1e6, " MB")})
    if (tenths(unit) < 1000) return numberText(tenths(unit)) + name;
  return numberText(tenths(1e9)) + " GB";
}

Character characterAt(const std::string& text, std::size_t at) {
  constexpr std::array<char32_t, 4> least{0, 0x80, 0x800, 0x10000};
  const auto lead = leadOf(static_cast<unsigned char>(text[at]));
  if (!lead || at + lead->first >= text.size()) return {};
  auto [more, c] = *lead;
  for (std::size_t k = 1; k <= more; ++k) {
    const auto byte = static_cast<unsigned char>(text[at + k]);
    if ((byte & 0xC0U) != 0x80U) return {};
    c = c << 6U | (byte & 0x3FU);
  }
  const bool isSurrogate = c >= 0xD800 && c < 0xE000;
  if (c < least[more] || c > 0x10FFFF || isSurrogate) return {};
  return {c, more + 1};
}

std::vector<std::string> charactersOf(const std::string& text) {
  std::vector<std::string> characters;
  for (std::size_t at = 0; at < text.size(); at += characters.back().size())
    characters.push_back(text.substr(at, characterAt(text, at).bytes));
  return characters;
}

bool isControl(char32_t c) {
  constexpr std::array<std::pair<char32_t, char32_t>, 10> ranges{{{0x00, 0x1F},
                                                                  {0x7F, 0x9F},
                                                                  {0xAD, 0xAD},
                                                                  {0x61C, 0x61C},
                                                                  {0x200B, 0x200B},
                                                                  {0x200E, 0x200F},
                                                                  {0x2028, 0x202E},
                                                                  {0x2060, 0x206F},
                                                                  {0xFEFF, 0xFEFF},
                                                                  {0xFFFE, 0xFFFF}}};
  return std::ranges::any_of(
      ranges, [c](const auto& range) { return c >= range.first && c <= range.second; });
}

std::string printable(const std::string& text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const auto [point, bytes] = characterAt(text, at);
    if (point && !isControl(*point))
      line += text.substr(at, bytes);
    else if (!point || *point < 0x80)
      line += escape('x', 2, static_cast<unsigned char>(text[at]));
    else
      line += escape('u', 4, *point);
    at += bytes;
  }
  return line;
}

}  // namespace hogelscope
