// SPDX-License-Identifier: BSD-3-Clause
// Images of which only some rows are rendered, for estimating costs and errors.
#pragma once

#include <vector>

#include "core/engine/renderer.h"
#include "core/optics/simulate.h"

namespace hogelscope {

/// Rows [begin, end) of an image.
struct Band {
  int begin = 0;
  int end = 0;
};

/// Returns every `step`-th band of eight rows, spread over the image; the whole image for 1. The
/// bands of twice the step are a subset. `step` is a power of two, at most coarsestStep().
std::vector<Band> sampledBands(int height, int step);
/// Returns the largest step, a power of two up to 64, that leaves four bands; else 1.
int coarsestStep(int height);

/// Whether single bands can be rendered; false if pixels depend on others, as in a view that is
/// scaled up or has a lens table.
bool isSampled(const RenderJob& job);

/// Renders the bands with the fast engine; all rows unless isSampled(). Throws as
/// Renderer::render().
Image sampledPicture(const RenderJob& job, int step, Renderer& renderer, const Progress& progress);

/// Renders the bands with the reference engine. Throws as Simulation, and Cancelled.
Image sampledReference(const RenderJob& job, int step, const ParallelRows& parallelRows,
                       const Progress& progress);

/// Returns the view with sides divided by `divisor`, at least one pixel each.
RenderJob smaller(const RenderJob& job, int divisor);

}  // namespace hogelscope
