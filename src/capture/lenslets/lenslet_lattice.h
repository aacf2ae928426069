// SPDX-License-Identifier: BSD-3-Clause
// Where the lenslets lie in a picture (docs/formulas.md, Lenslets).
#pragma once

#include <complex>

#include "core/light_field/lenslet_params.h"
#include "core/light_field/texel.h"

namespace hogelscope {

/// A point of a picture, x + i·y in pixels, y downwards; the middle of the top left pixel is 0.
using PicturePoint = std::complex<double>;

/// Lenslet n of a row.
struct LensletPlace {
  int n = 0;
  int row = 0;
};

struct LensletLattice {
  LensletGrid grid = LensletGrid::square;
  PicturePoint origin;  ///< middle of a lenslet
  PicturePoint step;    ///< to the next lenslet of the row

  [[nodiscard]] double pitch() const { return std::abs(step); }
  [[nodiscard]] double rotation() const;  ///< degrees, clockwise in the picture
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
  /// Returns where hogel i of row j lies among the row's lenslets: always lenslet i if the grid is
  /// square.
  [[nodiscard]] double lensletOfHogel(int i, int j) const {
    return i * rowDistance() - j * rowStep().real();
  }
};

/// Makes one of these parameters, of which all are given.
LensletLattice latticeOf(const LensletParams& params);

/// A picture with lenslets, and the rectangle of directions around the middle of each that hogels
/// take from it, at most one pitch wide and high.
struct LensletArea {
  int width = 0;
  int height = 0;
  int du = 0;
  int dv = 0;
};

/// Hogels nx × ny, of which (0, 0) is at the lattice's origin.
struct HogelBlock {
  LensletLattice lattice;
  int nx = 0;
  int ny = 0;
};

/// Returns the largest block of hogels that begins at the lattice's origin and has only lenslets
/// whose directions are all in the picture. Empty if there is none.
HogelBlock blockFromOrigin(const LensletLattice& lattice, const LensletArea& area);
/// Returns the largest one that begins anywhere.
HogelBlock largestBlock(const LensletLattice& lattice, const LensletArea& area);

}  // namespace hogelscope
