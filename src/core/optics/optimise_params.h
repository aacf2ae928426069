// SPDX-License-Identifier: BSD-3-Clause
// The session's `optimise`: what a display with leakage should be given, so that its views come
// closest to what they should be (docs/formulas.md, Optimised content).
#pragma once

#include <array>
#include <string>

#include "core/base/parameters.h"

namespace hogelscope {

/// Says what the views should look like. light: each directional pixel as the light field's own;
/// ideal: the ideal views of the states; views: a picture for each state.
enum class OptimiseTarget { light, ideal, views };

struct OptimiseParams {
  OptimiseTarget target = OptimiseTarget::light;
  std::string views;        ///< a folder with STATE.png or another picture for each state
  double keep = 0.05;       ///< weight of the own light, in the mean one of seen texels
  int samples = 16;         ///< of each texel of a live scene, over its hogel and direction
  int iterations = 100;     ///< at most, of each hogel
  double tolerance = 0.01;  ///< dB; a hogel is done where ten iterations gain less
  std::array<double, 2> lift{0, 0};  ///< of black and of white, parts of white
  int heldOut = 8;                   ///< eyes that judge the result and are not optimised for
  int seed = 1;                      ///< of their places
  bool operator==(const OptimiseParams&) const = default;
};

void describe(ParameterVisitor& v, OptimiseParams& p);

/// Visits its fields and its folder (SectionVisitor, io/json/sections.h).
template <class Visitor>
void describeParts(Visitor& v, OptimiseParams& p) {
  v.fields(p);
  v.file(p.views);
}

}  // namespace hogelscope
