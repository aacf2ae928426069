// SPDX-License-Identifier: BSD-3-Clause
// Images by the fast engine.
#pragma once

#include "core/engine/renderer.h"

/// On the calling thread, without regard to the view's tolerance.
inline hogelscope::Image rendered(hogelscope::RenderJob job) {
  job.sampling.tolerance = 0;
  return hogelscope::Renderer(hogelscope::serialRows).render(job);
}
