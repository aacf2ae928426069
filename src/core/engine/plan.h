// SPDX-License-Identifier: BSD-3-Clause
// What a view needs to have modelled, and what not: decided before the work. Words for it are in
// plan_words.h.
#pragma once

#include "core/lens/lens_table.h"
#include "core/optics/simulate.h"

namespace hogelscope {

struct Plan {
  bool hasLens = false;          ///< rays go through the lens model
  bool isTableKept = false;      ///< its rays are kept in a table
  bool hasLinearHogels = false;  ///< hits are affine in the rays' slopes
  bool isBehind = false;         ///< the eye is not in front of the panel: no rays at all
  bool knowsOutline = false;     ///< the part of each row that sees the display is known beforehand
  int psfReach = 0;              ///< taps on each side: (windowSize - 1) / 2, or fewer
  bool sumsTexels = false;       ///< a pixel is more than one texel
  bool sumsLinear = false;       ///< light is decoded before it is summed
  bool copiesTexels = false;     ///< each pixel is one stored texel of 8 bits, in memory
};

/// `view.lightField` must be there.
Plan plan(const View& view);
/// The same with the view's display.
Plan plan(const View& view, const Display& display);

/// What a pixel changes by at most, in code values, if leakage reaches only `reach` taps to each
/// side.
double leakageLoss(const PsfParams& psf, int reach);

/// Throws InputError as Camera does.
LensKey lensKeyOf(const CameraState& state, const SamplingParams& sampling,
                  const Method& method = {});
/// The same with the state's camera.
LensKey lensKeyOf(const Camera& camera, const CameraState& state, const SamplingParams& sampling,
                  const Method& method = {});

}  // namespace hogelscope
