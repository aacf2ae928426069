// SPDX-License-Identifier: BSD-3-Clause
// A small view of noise.
#pragma once

#include <memory>
#include <vector>

#include "core/light_field/light_field.h"
#include "core/optics/simulate.h"
#include "tests/core/random.h"

/// Returns 16×12 hogels of 11×9 directions with noise, seen from the front.
inline hogelscope::RenderJob sampleView() {
  using namespace hogelscope;
  Random random(3);
  const LightFieldSize size{16, 12, 11, 9};
  std::vector<std::uint8_t> values(3 * size.width() * size.height());
  for (std::uint8_t& value : values) value = static_cast<std::uint8_t>(random.integer(0, 255));
  RenderJob job;
  job.lightField = std::make_shared<LightField>(size, values);
  job.display.hogels = {16, 12};
  job.display.directions = {11, 9};
  job.state.camera.eye = {0.03, 0.02, 0.6};
  job.state.camera.lookat = {0.013, 0.007, 0};
  job.state.camera.res = {70, 50};
  return job;
}
