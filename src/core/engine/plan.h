// SPDX-License-Identifier: BSD-3-Clause
// The plan of a view: the decisions before rendering on what is modelled and what is left out.
// plan_words.h describes it in words.
#pragma once

#include "core/lens/lens_table.h"
#include "core/optics/simulate.h"

namespace hogelscope {

struct Plan {
  Aperture aperture;             ///< the points from which the view is taken
  bool hasLens = false;          ///< rays go through the lens model
  bool isTableKept = false;      ///< its rays are kept in a table
  bool hasLinearHogels = false;  ///< hits are affine in the rays' slopes
  bool movesRays = false;        ///< rays meet a twin, not the design
  int spotReach = 0;             ///< a lens sheet's pixels to either side that a ray reads
  bool copiesPixels = false;     ///< a lens sheet's sub-pixels are copied
  bool splitsColours = false;    ///< a twin whose colours meet pixels of their own
  bool changesLight = false;     ///< a twin that scales or adds light
  bool drivesTexels = false;     ///< a twin whose texels are other light, or none
  bool leaksOverField = false;   ///< a twin's leakage differs between directions or colours
  bool isBehind = false;         ///< the eye is not in front of the panel, so there are no rays
  bool knowsOutline = false;  ///< the columns of each row that see the display are known beforehand
  int psfReach = 0;           ///< taps on each side: (windowSize - 1) / 2, or fewer
  bool sumsTexels = false;    ///< the light from one point of the aperture is of several texels
  bool sumsLinear = false;    ///< light is decoded before it is summed
  bool copiesTexels = false;  ///< each pixel is one stored texel of 8 bits, in memory
  bool usesStrips = false;    ///< cells are found from polynomials of the lens's strips
};

/// Makes the plan of a view; `job.lightField` must not be null.
Plan plan(const RenderJob& job);
/// Makes the same plan with an existing Display of the view.
Plan plan(const RenderJob& job, const Display& display);

/// Returns the largest change of a pixel, in code values, if leakage is cut to `reach` taps on each
/// side.
double leakageLoss(const PsfParams& psf, int reach);

/// Returns the key of the state's lens. Throws InputError as Camera does.
LensKey lensKeyOf(const CameraState& state, const SamplingParams& sampling,
                  const Method& method = {});
/// Returns the same key with an existing Camera of the state.
LensKey lensKeyOf(const Camera& camera, const CameraState& state, const SamplingParams& sampling,
                  const Method& method = {});

}  // namespace hogelscope
