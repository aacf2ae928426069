// SPDX-License-Identifier: BSD-3-Clause
// Lines and words of OBJ and MTL files.
#pragma once

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "srgb.h"

namespace hogelscope::mesh {

/// The words of one line.
class Words {
 public:
  explicit Words(std::string_view line) : m_rest(line) {}

  /// Returns the next word, or "".
  std::string_view next() {
    m_rest.remove_prefix(std::min(m_rest.find_first_not_of(" \t\r"), m_rest.size()));
    const std::string_view word = m_rest.substr(0, m_rest.find_first_of(" \t\r"));
    m_rest.remove_prefix(word.size());
    return word;
  }

  /// Returns the rest of the line, without blanks at its ends.
  std::string_view rest() {
    m_rest.remove_prefix(std::min(m_rest.find_first_not_of(" \t\r"), m_rest.size()));
    return m_rest.substr(0, m_rest.find_last_not_of(" \t\r") + 1);
  }

  /// Parses the next word as a number. Returns false if it is not one.
  bool number(double& value) {
    std::string_view word = next();
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
  }

 private:
  std::string_view m_rest;
};

/// Joins lines that a backslash at their end continues, blanks and a carriage return behind it
/// aside. A comment ends with its line, since it may be a path of Windows.
inline void joinContinuedLines(std::string& text) {
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 1)) {
    const std::size_t end = text.find_first_not_of(" \t\r", at + 1);
    if (end == std::string::npos || text[end] != '\n') continue;
    const std::size_t line = text.rfind('\n', at) + 1;  // 0 without one
    const std::size_t first = text.find_first_not_of(" \t", line);
    if (text[first] != '#') std::fill_n(text.begin() + std::ptrdiff_t(at), end + 1 - at, ' ');
  }
}

/// Calls `read` with each line and its number.
template <class Read>
void forLines(std::string_view text, const Read& read) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    read(text.substr(0, end), number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// Returns the linear light of a colour, which in these files is sRGB.
inline float linearFloat(double encoded) {
  return float(linearOf(std::clamp(encoded, 0.0, 1.0)));
}

}  // namespace hogelscope::mesh
