// SPDX-License-Identifier: BSD-3-Clause
// What a view needs to have modelled, and what not: decided before the work, with reasons that
// --explain prints.
#pragma once

#include <string>
#include <vector>

#include "core/lens/lens_table.h"
#include "core/optics/simulate.h"

namespace hogelscope {

/// One decision in words.
struct Decision {
  std::string what;
  std::string why;
  std::string saves;  ///< rays, taps or bytes; "" where it saves nothing
};

struct Plan {
  bool hasLens = false;       ///< rays go through the lens model
  bool isTableKept = false;   ///< its rays are kept in a table
  bool knowsOutline = false;  ///< the part of each row that sees the display is known beforehand
  int psfReach = 0;           ///< taps on each side: (windowSize - 1) / 2, or fewer
  bool sumsLinear = false;    ///< light is decoded before it is summed
  bool copiesTexels = false;  ///< each pixel is one stored texel
  std::vector<Decision> decisions;
};

/// `view.lightField` must be loaded.
Plan plan(const View& view);

/// How the view renders, in one line: "nearest, 1 ray a pixel, 25 of 25 taps, lens table kept".
std::string oneLine(const View& view, const Plan& plan);

/// What a pixel changes by at most, in code values, if leakage reaches only `reach` taps to each
/// side.
double leakageLoss(const PsfParams& psf, int reach);

LensKey lensKeyOf(const CameraState& state, const SamplingParams& sampling,
                  const Method& method = {});

}  // namespace hogelscope
