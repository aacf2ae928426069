// SPDX-License-Identifier: BSD-3-Clause
// The pixels of a view that see a hogel.
#pragma once

#include <vector>

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/engine/view_rays.h"

namespace hogelscope {

/// Returns the pixels whose middle ray meets hogel (i, j) inside its angular field, from the top.
/// Throws InputError as Simulation does, and Cancelled.
std::vector<PixelRun> pixelsSeeing(const RenderJob& job, int i, int j,
                                   const ParallelRows& parallelRows, const Progress& progress = {});

}  // namespace hogelscope
