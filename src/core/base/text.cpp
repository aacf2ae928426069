// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/text.h"

#include <algorithm>
#include <array>
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

}  // namespace

std::string pairText(long long across, long long down) {
  return std::to_string(across) + "×" + std::to_string(down);
}

std::string lowerCase(std::string text) {
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'Z') letter = char(letter - 'A' + 'a');
  return text;
}

std::string csvCell(const std::string& text) {
  std::string harmless = isFormula(text) ? "'" + text : text;
  if (harmless.find_first_of(",\"\r\n") == std::string::npos) return harmless;
  std::string cell = "\"";
  for (const char c : harmless) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
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

std::string bytesText(std::size_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " bytes";
  const auto tenths = [bytes](double unit) { return std::round(10 * double(bytes) / unit) / 10; };
  for (const auto& [unit, name] : {std::pair(1e3, " kB"), std::pair(1e6, " MB")})
    if (tenths(unit) < 1000) return numberText(tenths(unit)) + name;
  return numberText(tenths(1e9)) + " GB";
}

}  // namespace hogelscope
