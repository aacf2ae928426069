// SPDX-License-Identifier: BSD-3-Clause
// Images of the fast engine.
#pragma once

#include "core/engine/renderer.h"

/// Renders on the calling thread, without the view's tolerance.
inline hogelscope::Image rendered(hogelscope::RenderJob job) {
  job.sampling.tolerance = 0;
  return hogelscope::Renderer(hogelscope::serialRows).render(job);
}
