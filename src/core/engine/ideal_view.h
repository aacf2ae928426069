// SPDX-License-Identifier: BSD-3-Clause
// The ideal view: the image that the camera would see of a live scene itself through the panel's
// window, without hogels, directions and leakage (docs/formulas.md, Live scenes).
#pragma once

#include "core/engine/view_rays.h"
#include "core/optics/image.h"

namespace hogelscope {

/// Renders the ideal view with the lens, the samples and the resolution of the view. A pixel is
/// seen exactly if it is seen in the view of the display as designed. Throws InputError as ViewRays
/// and LiveScene::trace() do, for a light field that is not live, and Cancelled.
FloatImage renderIdeal(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                       const Progress& progress = {});

}  // namespace hogelscope
