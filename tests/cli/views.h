// SPDX-License-Identifier: BSD-3-Clause
// The expected images, computed by the reference engine.
#pragma once

#include "io/documents/session_file.h"
#include "io/scene/view_source.h"

/// Returns an image for each state.
inline std::vector<hogelscope::Image> simulated(const hogelscope::Session& session) {
  const hogelscope::ViewSource scene = hogelscope::loadViewSource(session, {});
  std::vector<hogelscope::Image> images;
  for (const hogelscope::CameraState& state : session.cameras)
    images.push_back(hogelscope::simulate(scene.job(state)));
  return images;
}
