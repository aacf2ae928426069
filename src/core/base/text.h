// SPDX-License-Identifier: BSD-3-Clause
// Formats numbers, sizes and CSV cells as text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace hogelscope {

/// Returns the shortest text that reads back as the same number; "inf", "nan".
std::string numberText(double value);
/// Returns the number that all of the text is; none if it is anything else.
std::optional<double> numberOf(std::string_view text);
/// Rounds to four significant digits, for reading.
double fourDigits(double value);
/// Formats with `digits` after the point; "identical" if infinite, a dash if NaN.
std::string rounded(double value, int digits);
/// Formats a size, such as "512 bytes", "12.3 kB", "19.7 MB", "2.7 GB".
std::string bytesText(std::size_t bytes);

/// Returns "3×4".
std::string pairText(long long across, long long down);

/// Returns a text with the letters a … z for A … Z.
std::string lowerCase(std::string text);

/// Returns a text as a CSV cell (RFC 4180). A text that a spreadsheet would read as a formula gets
/// a leading apostrophe (OWASP, CSV injection).
std::string csvCell(const std::string& text);

}  // namespace hogelscope
