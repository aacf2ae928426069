// SPDX-License-Identifier: BSD-3-Clause
// Reads UTF-8, and makes other text safe for terminals and pages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace hogelscope {

/// A UTF-8 character (RFC 3629) and its bytes; no code point, and 1 byte, if no character begins
/// there.
struct Character {
  std::optional<char32_t> point;
  std::size_t bytes = 1;
};

/// Returns the character that begins at byte `at`.
Character characterAt(const std::string& text, std::size_t at);

/// Whether a character controls a terminal, ends a line, changes the writing direction or is
/// invisible. The joiners U+200C and U+200D are excluded, because some scripts need them.
bool isControl(char32_t c);

/// Returns the text as one line of UTF-8. Controls become \xNN or \uNNNN, and bytes that are not
/// UTF-8 \xNN. For file names, library messages and other foreign text.
std::string printable(const std::string& text);

}  // namespace hogelscope
