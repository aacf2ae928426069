// SPDX-License-Identifier: BSD-3-Clause
// Finds the distance of focus at which what a pixel shows is sharp.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/lens/lens_table.h"
#include "core/optics/simulate.h"

namespace hogelscope {

/// Returns the distance along the camera's axis, metres. For a scene of triangles it is that of the
/// first one that the pixel's ray meets. For other content it is the focus of greatest contrast in
/// the 15 × 15 pixels around this one, the standard deviation of their luminance, searched evenly
/// in dioptres from half the panel's distance to twice that. The state must have a pupil. None if
/// there is no ray or no contrast. Throws InputError as Simulation and LightFieldSource::slice()
/// do, and Cancelled.
std::optional<double> sharpestFocus(const RenderJob& job, int x, int y, LensTables& tables,
                                    const ParallelRows& parallelRows,
                                    const Progress& progress = {});

/// Returns which of the values `at(k)`, with k = 0 … count - 1, of a parameter of the content makes
/// what a pixel shows sharp, between two of them too: that of greatest contrast in the scene itself
/// around the pixel, as above. `lightField` returns the live content with a value. None if there is
/// no ray, or no contrast that changes with it. Throws as above.
std::optional<double> sharpestContent(
    const RenderJob& job, int x, int y, int count, const std::function<double(double k)>& at,
    const std::function<std::shared_ptr<const LightFieldSource>(double value)>& lightField,
    LensTables& tables, const ParallelRows& parallelRows, const Progress& progress = {});

}  // namespace hogelscope
