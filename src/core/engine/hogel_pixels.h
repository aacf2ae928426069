// SPDX-License-Identifier: BSD-3-Clause
// Finds the pixels of a view that see a hogel, and why others see none, by their middle rays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/engine/view_rays.h"
#include "core/optics/pixel_inspection.h"

namespace hogelscope {

/// Returns the view with only the ray from the eye through the middle of each pixel.
RenderJob middleRays(RenderJob job);

/// Returns the pixels whose middle ray meets hogel (i, j) inside its angular field, from the top.
/// Throws InputError as Simulation does, and Cancelled.
std::vector<PixelRun> pixelsSeeing(const RenderJob& job, int i, int j,
                                   const ParallelRows& parallelRows, const Progress& progress = {});

/// Returns the end of the ray through the middle of each pixel that is 0 in `seen`, a mask in the
/// camera's resolution, row by row from the top; RayEnd::seen for the others. Throws InputError as
/// Camera and lensOf() do, and Cancelled.
std::vector<RayEnd> rayEnds(const RenderJob& job, std::span<const std::uint8_t> seen,
                            const ParallelRows& parallelRows, const Progress& progress = {});

}  // namespace hogelscope
