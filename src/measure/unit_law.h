// SPDX-License-Identifier: BSD-3-Clause
// This is what closed forms know of a display as it was built: the errors that change a figure by a
// formula (docs/formulas.md, Measures of a unit). A unit's figures are those whose formula knows
// all of its errors; the others are named.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/panel/twin_params.h"

namespace hogelscope {

/// The numbers of a twin in the closed forms; those of a design by default.
struct UnitLaw {
  std::array<double, 3> scale{1, 1, 1};  ///< (1 + χ)(1 + γ) of red, green, blue
  std::array<double, 2> offset{};        ///< of the lens array, metres
  std::array<double, 2> pitchError{};
  double turn = 1;        ///< cosine of the lens array's rotation
  double defocus = 0;     ///< κ = (1 + γ)/(1 + focalError) − 1
  double shiftSigma = 0;  ///< of a hogel's lens, metres
  double black = 0;
  std::array<double, 3> ambient{};
};

UnitLaw unitLawOf(const TwinParams& twin);

/// Returns why a unit with this twin has no figure of this name: "no formula is of a unit", or
/// "no formula knows twin.light.falloff"; "" if it has.
std::string whyNotOfUnit(std::string_view figure, const TwinParams& twin);

}  // namespace hogelscope
