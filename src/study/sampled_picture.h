// SPDX-License-Identifier: BSD-3-Clause
// Pictures of which only some rows are rendered, and what a picture costs.
#pragma once

#include <vector>

#include "core/engine/renderer.h"
#include "core/optics/simulate.h"
#include "study/time_budget.h"

namespace hogelscope {

/// Rows [begin, end) of an image.
struct Band {
  int begin = 0;
  int end = 0;
};

/// Returns every `step`-th band of eight rows, spread over the image; the whole image for 1. Those
/// of twice the step are among them. `step` is a power of two, at most coarsestStep().
std::vector<Band> sampledBands(int height, int step);
/// Returns the largest step, a power of two up to 64, that leaves four bands; else 1.
int coarsestStep(int height);

/// False where pixels depend on those around them: of a view that is scaled up or has a lens table.
bool isSampled(const RenderJob& job);

/// Renders the bands by the fast engine; all rows unless isSampled(). Throws as Renderer::render().
Image sampledPicture(const RenderJob& job, int step, Renderer& renderer, const Progress& progress);

/// Renders the bands by the reference engine. Throws as Simulation, and Cancelled.
Image sampledReference(const RenderJob& job, int step, const ParallelRows& parallelRows,
                       const Progress& progress);

/// Returns the view with a `divisor`-th of its pixels along each side, one at least.
RenderJob smaller(const RenderJob& job, int divisor);

}  // namespace hogelscope
