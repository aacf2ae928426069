// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command_line.h"

#include <charconv>
#include <stdexcept>

namespace hogelscope {

namespace {

/// Quotes a word for a shell, if necessary.
std::string quoted(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

const std::vector<std::string>& CommandLine::texts(std::string_view option) const {
  const auto found = options.find(option);
  if (found == options.end())
    throw std::logic_error("--" + std::string(option) + " is read by a job that does not have it");
  return found->second;
}

std::string CommandLine::text(std::string_view option, const char* otherwise) const {
  return has(option) ? texts(option).front() : otherwise;
}

std::optional<double> CommandLine::number(std::string_view option) const {
  if (!has(option)) return {};
  const std::string& digits = texts(option).front();
  double value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

std::string shellText(const std::vector<std::string>& arguments) {
  std::string text = "hogelscope";
  for (const std::string& word : arguments) text += " " + quoted(word);
  return text;
}

}  // namespace hogelscope
