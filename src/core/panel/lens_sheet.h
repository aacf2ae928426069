// SPDX-License-Identifier: BSD-3-Clause
// A sheet of slanted cylindrical lenses over the sub-pixels of a panel, such as a Looking Glass
// has.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/parameters.h"

namespace hogelscope {

/// The places of a pixel's red, green and blue, px from its middle: to the right, upwards.
using SubPixels = std::array<std::array<double, 2>, 3>;

/// One unit's figures, as its vendor counts them.
struct SheetParams {
  double pitch = notGiven;         ///< lenses an inch, across the lenses
  double slope = notGiven;         ///< of the lenses: up for each unit to the right
  double center = notGiven;        ///< phase of the panel's middle, views' cycles
  double dpi = notGiven;           ///< pixels an inch
  std::array<int, 2> panel{0, 0};  ///< px
  double cone = notGiven;          ///< angle into which a lens spreads what is behind it, degrees
  bool operator==(const SheetParams&) const = default;
};

/// Throws InputError for a slope of 0.
void check(const SheetParams& params);
void describe(ParameterVisitor& v, SheetParams& p);

/// A calibration: its figures, and where the sub-pixels are.
struct SheetCalibration {
  std::string serial;
  SheetParams params;
  /// The kinds of pixels; one: vertical stripes of red, green and blue.
  std::vector<SubPixels> cells{{{{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 0}}}};
  int pattern = 0;  ///< how kinds alternate, CellPatternMode 0 … 4
};

/// What follows from the figures; lengths are metres. x is to the right.
struct LensSheet {
  explicit LensSheet(const SheetParams& params);

  double pixel;                ///< pitch of the pixels
  std::array<double, 2> size;  ///< of the panel
  double period;               ///< of the lenses along x, p = (0.0254/pitch)/cos(atan(1/slope))
  double lenses;               ///< along the panel's width, P
  double slant;                ///< of the lenses to the vertical, degrees; positive to the right
  double gap;                  ///< from lenses to pixels, in air, p/(2 tan(cone/2))
};

}  // namespace hogelscope
