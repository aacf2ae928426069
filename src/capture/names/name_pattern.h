// SPDX-License-Identifier: BSD-3-Clause
// Patterns of file names: which numbers in them are a view's row, column, or position.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hogelscope {

/// A part of a pattern.
struct NameToken {
  enum class Kind { letter, number, coordinate, anything, extension } kind;
  char letter;  ///< itself, or R, C, N, x, y for what a number means
};

struct NamePattern {
  std::vector<NameToken> tokens;
  std::string text;  ///< the text of the user

  /// Returns the letters of its numbers: "RC", "CR", "N"; or of its coordinates if it has no
  /// numbers: "xy", "yx", "x", "y".
  [[nodiscard]] std::string meaning() const;
};

/// Reads a pattern: RR, CC, NNN (or one such letter alone) are numbers, x and y alone are
/// coordinates, * anything; ".png" and the like may be left out. Throws InputError: too long, or it
/// names neither row and column, nor a running number, nor coordinates alone.
NamePattern namePattern(const std::string& text);

/// Reads printf's %d, %02d: row and column, or one running number. Throws InputError.
NamePattern percentPattern(const std::string& text);

/// Returns the numbers and coordinates in a name by their letters, the first of each; none if the
/// name does not match.
std::optional<std::map<char, std::string>> numbersIn(const std::string& name,
                                                     const NamePattern& pattern);

/// Returns a pattern that takes the numbers of rows for those of columns and the other way round,
/// or x for y where coordinates are all it has; "" for one running number, and for a file name with
/// %d.
std::string transposedPattern(const std::string& pattern);

}  // namespace hogelscope
