// SPDX-License-Identifier: BSD-3-Clause
// One map of a twin's measured values.
#pragma once

#include <vector>

namespace hogelscope {

/// Measured values, row by row from the top; empty if nothing was measured.
struct TwinPlane {
  int width = 0;
  int height = 0;
  std::vector<float> values;  ///< width·height

  [[nodiscard]] bool isEmpty() const { return values.empty(); }
  /// Returns the value at cell (i, j) of a grid of nx × ny cells over the same area: the plane's
  /// own if it has as many, else bilinear between the middles of its cells.
  [[nodiscard]] float atCell(int i, int j, int nx, int ny) const;
  /// Returns the value at (x, y), 0 … 1 from the left and the top: bilinear between the middles of
  /// its cells, beyond which it stays the same.
  [[nodiscard]] double at(double x, double y) const;
};

/// A place between the middles of two of `count` cells: the first one, and the share of the second,
/// which is beyond 0 … 1 outside the outermost middles.
struct PlanePlace {
  int first;
  double share;
};

/// Returns where a place, 0 … 1, is between the middles of `count` cells.
PlanePlace planePlaceOf(double place, int count);
/// Returns the same, with the share within 0 … 1.
PlanePlace within(PlanePlace place);

/// The bilinear function of a plane around a place.
struct Bilinear {
  Bilinear(const TwinPlane& plane, const PlanePlace& i, const PlanePlace& j);
  double value;
  double across;  ///< for each cell
  double down;
};

}  // namespace hogelscope
