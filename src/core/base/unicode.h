// SPDX-License-Identifier: BSD-3-Clause
// Reads UTF-8 and makes text of others harmless to terminals and pages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace hogelscope {

/// A character of UTF-8 (RFC 3629) and the bytes that it takes; no point, and 1 byte, where no
/// character begins.
struct Character {
  std::optional<char32_t> point;
  std::size_t bytes = 1;
};

/// Reads the character that begins at byte `at` of the text.
Character characterAt(const std::string& text, std::size_t at);

/// Whether a character controls a terminal, ends a line, turns the direction of writing or shows
/// nothing. The joiners U+200C and U+200D are none: some scripts need them.
bool isControl(char32_t c);

/// Returns the text as one line of UTF-8. Controls become \xNN or \uNNNN, and bytes that are not
/// UTF-8 \xNN. For names of files, messages of libraries and other text that is not ours.
std::string printable(const std::string& text);

}  // namespace hogelscope
