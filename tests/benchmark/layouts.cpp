// SPDX-License-Identifier: BSD-3-Clause
// How a light field had best lie in memory: the table in docs/measurements.md.
#include <bit>

#include "tests/benchmark/scene.h"

namespace benchmarks {

void addLayouts() {
  const auto whole = [](int cells) { return std::uint32_t(std::bit_width(unsigned(cells) - 1)); };
  const std::pair<const char*, Block> layouts[]{
      {"hogel-major", {0, 0, whole(directions), whole(directions)}},
      {"view-major", {whole(hogels), whole(hogels), 0, 0}},
      {"blocks 4x4x4x4", {2, 2, 2, 2}},
      {"blocks 8x8x4x4", {3, 3, 2, 2}},
      {"blocks 8x8x8x8", {3, 3, 3, 3}},
      {"blocks 16x16x8x8", {4, 4, 3, 3}},
  };
  for (const auto& [name, block] : layouts) {
    const auto plain = [block = block](int pose) { return viewOf(pose, block); };
    const auto leaking = [block = block](int pose) {
      hogelscope::RenderJob job = viewOf(pose, block);
      job.state.psf = {0.67, 5};
      return job;
    };
    add(std::string("layout/") + name + "/nearest", timeViews, plain, 0);
    add(std::string("layout/") + name + "/psf 5x5", timeViews, leaking, 0);
  }
}

}  // namespace benchmarks
