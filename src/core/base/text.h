// SPDX-License-Identifier: BSD-3-Clause
// Formats numbers, sizes and tables as text, reads UTF-8, and makes other text safe for
// terminals and pages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hogelscope {

/// Returns the shortest text that reads back as the same number; "inf", "nan".
std::string numberText(double value);
/// Returns the number that all of the text is; none if it is anything else.
std::optional<double> numberOf(std::string_view text);
/// Rounds to four significant digits, for reading.
double fourDigits(double value);
/// Formats with `digits` after the point; "identical" if infinite, a dash if NaN.
std::string rounded(double value, int digits);
/// Returns a text with a minus sign, U+2212, which is as wide as a plus, for each hyphen before a
/// number or in its exponent.
std::string withMinus(const std::string& text);
/// Formats a size, such as "512 bytes", "12.3 kB", "19.7 MB", "2.7 GB".
std::string bytesText(std::size_t bytes);

/// Returns "3×4".
std::string pairText(long long across, long long down);

/// Returns a text with the letters a … z for A … Z.
std::string lowerCase(std::string text);

/// Returns the label that forms derive from a name: "Window size" for "windowSize"; names without
/// vowels stay, as "PSF" or "k1".
std::string formLabel(std::string_view name);

/// A table: rows of cells, of which the first has the names of the columns.
using Table = std::vector<std::vector<std::string>>;

/// Returns a table as CSV (RFC 4180). A cell that a spreadsheet would read as a formula gets a
/// leading apostrophe (OWASP, CSV injection).
std::string csvText(const Table& table);
/// Returns a number as a cell; an empty one for NaN.
std::string numberCell(double value);

/// Returns the table that a text of CSV has.
Table csvRows(std::string_view text);

/// A UTF-8 character (RFC 3629) and its bytes; no code point, and 1 byte, if no character begins
/// there.
struct Character {
  std::optional<char32_t> point;
  std::size_t bytes = 1;
};

/// Returns the character that begins at byte `at`.
Character characterAt(const std::string& text, std::size_t at);
/// Returns a text's characters, each byte that is no part of one by itself.
std::vector<std::string> charactersOf(const std::string& text);

/// Whether a character controls a terminal, ends a line, changes the writing direction or is
/// invisible. The joiners U+200C and U+200D are excluded, because some scripts need them.
bool isControl(char32_t c);

/// Returns the text as one line of UTF-8. Controls become \xNN or \uNNNN, and bytes that are not
/// UTF-8 \xNN. For file names, library messages and other foreign text.
std::string printable(const std::string& text);

}  // namespace hogelscope
