// SPDX-License-Identifier: BSD-3-Clause
// Reads tables of the light that directional pixels send, as goniometers measure it: CSV.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace hogelscope {

/// Measured values of a hogel's directional pixels, of which the table may have a part. All lists
/// run over the directions, row by row from the top.
struct MeasuredDirections {
  std::array<int, 2> size{};  ///< directions across and down
  std::vector<bool> isGiven;
  /// The slopes x (right) and y (up), then 0, 1 or 3 lists of light as parts of the list's largest
  /// value: none, of all colours, or of red, green and blue.
  std::vector<std::vector<double>> values;

  [[nodiscard]] std::size_t at(int u, int v) const {
    return std::size_t(v) * std::size_t(size[0]) + std::size_t(u);
  }
};

/// Reads a table whose first line names its columns in any order: u, v (from the left and the top,
/// from 0), x, y, and none of r, g, b, intensity, the first three or the last. Throws InputError
/// that names the line.
MeasuredDirections parseMeasuredDirections(std::string_view text,
                                           const std::array<int, 2>& directions);

}  // namespace hogelscope
