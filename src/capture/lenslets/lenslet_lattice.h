// SPDX-License-Identifier: BSD-3-Clause
// The lattice of the lenslets in an image (docs/formulas.md, Lenslets).
#pragma once

#include <complex>

#include "core/light_field/layout_params.h"
#include "core/light_field/texel.h"

namespace hogelscope {

/// A point of an image, x + i·y in pixels, y downwards; the middle of the top left pixel is 0.
using PicturePoint = std::complex<double>;

/// The index of a lenslet: number n of a row.
struct LensletPlace {
  int n = 0;
  int row = 0;
};

struct LensletLattice {
  LensletGrid grid = LensletGrid::square;
  PicturePoint origin;  ///< middle of a lenslet
  PicturePoint step;    ///< to the next lenslet of the row

  [[nodiscard]] double pitch() const { return std::abs(step); }
  [[nodiscard]] double rotation() const;  ///< degrees, clockwise in the image
  /// Returns the step from a lenslet to one of the next row, in steps of a row: i, or ½ + i·√3/2.
  [[nodiscard]] PicturePoint rowStep() const;
  /// Returns the distance of rows in pitches, which is that of the hogels too.
  [[nodiscard]] double rowDistance() const { return rowStep().imag(); }
  /// Returns the middle of the lenslet n of row j; a row of a hexagonal grid is shifted by half a
  /// pitch against the row above.
  [[nodiscard]] PicturePoint middle(double n, int j) const {
    return origin + step * (n + double(j) * rowStep());
  }
  /// Returns the lenslet of the row that is nearest to a point.
  [[nodiscard]] LensletPlace nearestTo(const PicturePoint& point) const;
  /// Returns the position of hogel i of row j in the row, counted in lenslets: i if the grid is
  /// square.
  [[nodiscard]] double lensletOfHogel(int i, int j) const {
    return i * rowDistance() - j * rowStep().real();
  }
};

/// Returns the lattice of parameters that are all given.
LensletLattice latticeOf(const LensletParams& params);

/// The size of an image with lenslets, and of the rectangle of directions around each lenslet's
/// middle, of which hogels use at most one pitch in width and height.
struct LensletArea {
  int width = 0;
  int height = 0;
  int du = 0;
  int dv = 0;
};

/// A block of nx × ny hogels; hogel (0, 0) is at the lattice's origin.
struct HogelBlock {
  LensletLattice lattice;
  int nx = 0;
  int ny = 0;
};

/// Returns the largest block of hogels that begins at the lattice's origin and has only lenslets
/// whose directions are all in the image. Empty if there is none.
HogelBlock blockFromOrigin(const LensletLattice& lattice, const LensletArea& area);
/// Returns the largest such block that begins at any lenslet.
HogelBlock largestBlock(const LensletLattice& lattice, const LensletArea& area);

}  // namespace hogelscope
