// SPDX-License-Identifier: BSD-3-Clause
// Where the time of a ray goes: each kernel alone, on a batch in the first-level cache, in cycles
// of the processor's nominal frequency.
#include <random>

#include "core/engine/tap_kernels.h"
#include "tests/benchmark/scene.h"

namespace benchmarks {

using namespace hogelscope;

namespace {

/// One batch of rays of a view of the paper's display, and what each kernel needs of it.
struct Rays {
  HitMap map;
  BlockLayout layout{{512, 512, 64, 64}, {3, 3, 3, 3}};
  BlockLayout oneTexel;  ///< every address is 0
  std::array<double, batchSize> x{};
  std::array<double, batchSize> y{};
  std::array<std::uint32_t, batchSize> address{};
  CellBatch cells{};
  std::array<std::uint32_t, 2 * batchSize> offset{};
  std::array<float, 2 * batchSize> weight{};
  std::vector<Texel<std::uint8_t>> texels = std::vector<Texel<std::uint8_t>>(4096);
  std::array<std::uint8_t, 3 * batchSize> rgb{};
  std::array<std::uint8_t, batchSize> seen{};
  std::vector<std::array<std::uint32_t, batchSize>> taps;
  std::vector<float> share;
  LightBatch sum{};

  explicit Rays(int tapCount = 8) : taps(std::size_t(tapCount)), share(taps.size(), 0.1F) {
    map.right = {0.8, 0, -0.6};  // an orthonormal frame
    map.down = {0, -1, 0};
    map.forward = {-0.6, 0, -0.8};
    map.panel.constant = {256, 256, 32, 32};
    map.panel.slope = {-120, 400, -20, 60};
    map.panel.count = {512, 512, 64, 64};
    map.finder = Finder::design;
    for (std::size_t k = 0; k < batchSize; ++k) {
      x[k] = 0.0013 * double(k) - 0.1;
      y[k] = 0.05 + 0.00001 * double(k);
    }
    std::mt19937 random(1);
    for (auto& at : address) at = random() % 2048;
    for (auto& tap : taps)
      for (auto& at : tap) at = random() % 2048;
    findCells(map, x.data(), y.data(), batchSize, cells);
  }
};

template <class Kernel>
void time(benchmark::State& state, int perRay, Kernel kernel) {
  Rays rays;
  for (auto _ : state) {
    kernel(rays);
    benchmark::ClobberMemory();
  }
  const double done = double(state.iterations()) * batchSize * perRay;
  state.counters["cycles"] =
      benchmark::Counter(done / benchmark::CPUInfo::Get().cycles_per_second,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class Kernel>
void addKernel(const char* name, int perRay, Kernel kernel) {
  benchmark::RegisterBenchmark(
      name, [perRay, kernel](benchmark::State& state) { time(state, perRay, kernel); });
}

}  // namespace

void addKernels() {
  addKernel("kernel/copy, a row that hits", 1, [](Rays& r) {
    const RayRow row{r.x.data(),   r.y.data(),    batchSize,
                     r.rgb.data(), r.seen.data(), {0, batchSize}};
    copyRays(r.map, r.oneTexel, r.texels.data(), true, std::span(&row, 1));
  });
  addKernel("kernel/copy, any rays", 1, [](Rays& r) {
    const RayRow row{r.x.data(), r.y.data(), batchSize, r.rgb.data(), r.seen.data()};
    copyRays(r.map, r.oneTexel, r.texels.data(), false, std::span(&row, 1));
  });
  addKernel("kernel/cells and the places in them", 1,
            [](Rays& r) { findCells(r.map, r.x.data(), r.y.data(), batchSize, r.cells); });
  addKernel("kernel/interpolation, an axis", 1, [](Rays& r) {
    bracketingCells(r.layout.u, 64, r.cells.cell[2].data(), r.cells.place[2].data(),
                    r.offset.data(), r.weight.data());
  });
  addKernel("kernel/sum, a tap", 8, [](Rays& r) {
    accumulate(r.texels.data(),
               {int(r.taps.size()), r.address.data(), r.taps.data(), r.share.data()}, batchSize,
               r.sum);
  });
}

}  // namespace benchmarks
