// SPDX-License-Identifier: BSD-3-Clause
// The directional pixels that a view may read. All rays of a camera meet in its eye, so each column
// of hogels shows it a narrow range of u, and each row of hogels a narrow range of v: a view of the
// paper's light field needs some 50 MB.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hogelscope {

/// Cells [first, last]; empty where last < first.
struct CellRange {
  int first = 0;
  int last = -1;

  [[nodiscard]] bool isEmpty() const { return last < first; }
  [[nodiscard]] std::size_t size() const { return isEmpty() ? 0 : std::size_t(last - first) + 1; }
  [[nodiscard]] bool covers(const CellRange& other) const {
    return other.isEmpty() || (first <= other.first && other.last <= last);
  }
  /// Extends this range to cover the other one.
  void include(const CellRange& other) {
    if (other.isEmpty()) return;
    if (isEmpty()) {
      *this = other;
      return;
    }
    first = std::min(first, other.first);
    last = std::max(last, other.last);
  }
  bool operator==(const CellRange&) const = default;
};

struct Footprint {
  Footprint() = default;
  /// Makes empty ranges for nx columns and ny rows of hogels.
  Footprint(int nx, int ny) : u(std::size_t(nx)), v(std::size_t(ny)) {}

  std::vector<CellRange> u;  ///< for each column of hogels i
  std::vector<CellRange> v;  ///< for each row of hogels j

  /// Returns the number of directional pixels.
  [[nodiscard]] std::size_t texels() const;
  [[nodiscard]] bool covers(const Footprint& other) const;
  void include(const Footprint& other);
  bool operator==(const Footprint&) const = default;
};

}  // namespace hogelscope
