// SPDX-License-Identifier: BSD-3-Clause
// Patterns of file names, which give the numbers in a name a meaning: a view's row, column or
// position.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hogelscope {

/// A part of a pattern.
struct NameToken {
  enum class Kind { letter, number, coordinate, anything, extension } kind;
  char letter;  ///< the letter itself, or R, C, N, x, y, T (of the frame): a number's meaning
};

struct NamePattern {
  std::vector<NameToken> tokens;
  std::string text;  ///< the pattern as written

  /// Returns the letters of its numbers: "RC", "CR", "N"; or of its coordinates if it has no
  /// numbers: "xy", "yx", "x", "y". The number of a frame is none of them.
  [[nodiscard]] std::string meaning() const;
};

/// Reads a pattern: RR, CC, NNN (or one such letter alone) are numbers, x and y alone are
/// coordinates (but not between digits, as in 64x32), {T} is the number of a frame, * is any text;
/// an extension such as ".png" may be left out. Throws InputError if it is too long, or has neither
/// row and column, nor a running number, nor only coordinates.
NamePattern namePattern(const std::string& text);

/// Reads a pattern with printf's %d or %02d: row and column, or one running number. Throws
/// InputError.
NamePattern percentPattern(const std::string& text);

/// Returns the numbers and coordinates in a name by their letters, the first of each; none if the
/// name does not match.
std::optional<std::map<char, std::string>> numbersIn(const std::string& name,
                                                     const NamePattern& pattern);

/// Returns the pattern with rows and columns exchanged, or x and y if it has only coordinates; ""
/// for one number or coordinate, and for a file name with %d.
std::string transposedPattern(const std::string& pattern);

}  // namespace hogelscope
