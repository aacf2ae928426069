// SPDX-License-Identifier: BSD-3-Clause
// Views of units and lens sheets with any errors, in scenes at the limits of the parameters and
// through pupils: no memory but their own is read, and both engines see the same.
#include "core/engine/renderer.h"
#include "tests/core/extreme_unit.h"
#include "tests/core/unclear_rays.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

namespace {

/// Returns another seed for any other input (FNV-1a).
std::uint64_t seedOf(std::string_view input) {
  std::uint64_t seed = 14695981039346656037ULL;
  for (const char c : input) seed = (seed ^ std::uint8_t(c)) * 1099511628211ULL;
  return seed;
}

bool agree(const RenderJob& job, const Image& fast, const Image& reference) {
  const UnclearRays rays(job);
  for (std::size_t at = 0; at < fast.pixelCount(); ++at) {
    bool isSame = fast.seen[at] == reference.seen[at];
    for (std::size_t k = 3 * at; k < 3 * at + 3; ++k)
      isSame = isSame && std::abs(fast.rgb[k] - reference.rgb[k]) <= 1;
    if (!isSame && !rays.isUnclear(int(at) % fast.width, int(at) / fast.width)) return false;
  }
  return true;
}

}  // namespace

void fuzz(std::string_view input) {
  mayRefuse([&] {
    Random random(seedOf(input));
    const RenderJob job = extreme::unitScene(random, random.flip()).job;
    Renderer renderer(serialRows);
    require(agree(job, renderer.render(job), simulate(job)));
    (void)renderer.renderFloat(job);
  });
}
