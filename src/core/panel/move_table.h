// SPDX-License-Identifier: BSD-3-Clause
// A twin's map of directions for kernels, and its inverse.
#pragma once

#include <array>
#include <vector>

#include "core/panel/twin_plane.h"

namespace hogelscope {

/// The map (u, v) → (u, v) + m(u, v), where m is bilinear between the middles of width × height
/// cells over the field, and stays the same beyond the outermost.
class MoveTable {
 public:
  using Pair = std::array<float, 2>;  ///< of u and of v, directions

  MoveTable() = default;
  /// An empty plane moves nothing. The table is empty for planes of one row or column.
  MoveTable(const TwinPlane& moveU, const TwinPlane& moveV, const std::array<int, 2>& directions);

  [[nodiscard]] bool isEmpty() const { return m_moves.empty(); }
  /// Returns the largest |m|.
  [[nodiscard]] const std::array<double, 2>& largest() const { return m_largest; }

  /// Returns what is to be added to a place of the field to invert the map, within error(), for
  /// each of perDirection() × perDirection() cells of each direction, row by row.
  [[nodiscard]] const std::vector<Pair>& back() const { return m_back; }
  [[nodiscard]] int perDirection() const { return m_perDirection; }
  [[nodiscard]] const std::array<double, 2>& error() const { return m_error; }

  /// Returns the (u, v) that the map takes to (u₀, v₀), which may be outside the field.
  [[nodiscard]] std::array<double, 2> solve(double u0, double v0) const;

 private:
  /// The move at a place, and how it grows for each direction across and down.
  struct Move {
    std::array<double, 2> m;
    std::array<double, 2> across;
    std::array<double, 2> down;
  };
  [[nodiscard]] Move moveAt(double u, double v) const;
  void prepareBack();

  std::array<int, 2> m_size{};
  std::array<int, 2> m_directions{};
  std::array<double, 2> m_cells{};  ///< of the map for each direction
  std::vector<Pair> m_moves;
  std::vector<Pair> m_back;
  int m_perDirection = 1;
  std::array<double, 2> m_largest{};
  std::array<double, 2> m_error{};
};

}  // namespace hogelscope
