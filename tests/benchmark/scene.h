// SPDX-License-Identifier: BSD-3-Clause
// The scene of the benchmarks: the paper's display and camera with noise on the display, and 64
// alternating poses, so that nothing is cached between views.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <optional>

#include "core/optics/simulate.h"

namespace benchmarks {

constexpr int poses = 64;
inline int hogels = 512;     ///< across and down, set by --hogels
inline int directions = 64;  ///< set by --directions

using Block = std::array<std::uint32_t, 4>;

/// Returns the light field, in its own blocks without others; only the latest one is kept.
std::shared_ptr<const hogelscope::LightField> lightField(const std::optional<Block>& block = {});

/// Returns a view with nearest reconstruction, no leakage and an undistorted lens.
hogelscope::RenderJob viewOf(int pose, const std::optional<Block>& block = {});

/// Times whole images of the fast engine; each iteration has another pose. `threads` 0: all cores.
void timeViews(benchmark::State& state, const std::function<hogelscope::RenderJob(int)>& make,
               int threads);

/// Reports rays/s and views/s.
void countViews(benchmark::State& state, std::int64_t pixels = 600 * 600);

template <class Function, class... Arguments>
void add(const std::string& name, Function function, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

void addKernels();
void addViews();
void addLens();
void addLayouts();
void addOneThread();

}  // namespace benchmarks
