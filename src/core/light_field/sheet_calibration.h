// SPDX-License-Identifier: BSD-3-Clause
// A lens sheet's calibration: the figures of one unit, for which a panel's picture is woven.
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
  double slope = notGiven;         ///< a lens goes up by −slope for each unit to the right
  double center = notGiven;        ///< phase of the panel's middle, periods of the views
  double dpi = notGiven;           ///< pixels an inch
  std::array<int, 2> panel{0, 0};  ///< px
  double cone = notGiven;          ///< angle into which a lens spreads what is behind it, degrees
  bool operator==(const SheetParams&) const = default;
};

/// Throws InputError for a figure that is missing, and for lenses along the rows, |slope| < 0.001.
void check(const SheetParams& params);
void describe(ParameterVisitor& v, SheetParams& p);

/// A calibration: its figures, and where the sub-pixels are.
struct SheetCalibration {
  std::string serial{};
  SheetParams params;
  /// The kinds of pixels; one: vertical stripes of red, green and blue.
  std::vector<SubPixels> cells{{{{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 0}}}};
  int pattern = 0;          ///< how kinds alternate, CellPatternMode 0 … 4
  bool isInverted = false;  ///< the document says that views go from the right, which is ignored
  bool operator==(const SheetCalibration&) const = default;
};

}  // namespace hogelscope
