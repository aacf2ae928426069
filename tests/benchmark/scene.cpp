// SPDX-License-Identifier: BSD-3-Clause
// The scene of the benchmarks, and the program itself.
//
//   hogelscope-benchmark --hogels=512 --directions=64 --benchmark_repetitions=5
//     --benchmark_report_aggregates_only=true --benchmark_out=views.json
#include "tests/benchmark/scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <numbers>

#include "core/base/multiversioned.h"
#include "core/base/parallel.h"
#include "core/engine/fast_simulation.h"
#include "core/engine/plan.h"

namespace benchmarks {

using namespace hogelscope;

namespace {

/// Noise: every cache line is different.
void fillRows(LightField& field, int begin, int end) {
  for (int j = begin; j < end; ++j)
    for (int v = 0; v < directions; ++v)
      for (int i = 0; i < hogels; ++i)
        for (int u = 0; u < directions; ++u) {
          const std::uint32_t noise =
              std::uint32_t(((j * directions + v) * hogels + i) * directions + u) * 2654435761U;
          std::array<std::uint8_t, 4> rgb{};
          std::memcpy(rgb.data(), &noise, 4);
          field.set({i, j, u, v}, rgb.data());
        }
}

/// As Linux says it.
std::string processorName() {
  std::ifstream info("/proc/cpuinfo");
  const std::string key = "model name";
  for (std::string line; std::getline(info, line);)
    if (line.starts_with(key)) return line.substr(line.find(':') + 2);
  return "unknown";
}

/// Returns what a nearest view reads of a lens's table.
std::string lensTableForms() {
  RenderJob job;
  job.lightField = std::make_shared<LightField>(LightFieldSize{1, 1, 1, 1}, StoredType::uint8);
  job.display.hogels = job.display.directions = {1, 1};
  job.state.distortion.k1 = 0.1;
  const Plan planned = plan(job);
  return planned.usesStrips ? "strips, and points in double near borders" : "points in double";
}

/// Takes --name=value out of the arguments.
void takeFlag(int& argc, char** argv, const char* name, int& value) {
  const std::size_t length = std::strlen(name);
  for (int k = 1; k < argc; ++k) {
    if (std::strncmp(argv[k], name, length) != 0) continue;
    value = std::atoi(argv[k] + length);
    std::move(argv + k + 1, argv + argc, argv + k);
    --argc;
    return;
  }
}

/// Prints after all benchmarks what views take of their limits, and a lens of a view without.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  RatioReporter() : ConsoleReporter(OO_None) {}
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration || run.aggregate_name == "median")
        m_times[run.run_name.function_name].push_back(run.GetAdjustedRealTime());
  }
  void Finalize() override {
    for (const auto& [name, times] : m_times) {
      if (name.starts_with("view/")) print(name, "limit/" + name.substr(5));
      if (const std::size_t at = name.find(", of a capture"); at != std::string::npos)
        print(name, name.substr(0, at));
      if (const std::size_t at = name.find(" distorted"); at != std::string::npos)
        print(name, name.substr(0, at));
    }
  }

 private:
  void print(const std::string& name, const std::string& other) {
    if (!m_times.contains(other)) return;
    std::cout << name << ": " << median(name) / median(other) << " times " << other << '\n';
  }
  double median(const std::string& name) {
    std::vector<double>& times = m_times[name];
    const auto middle = times.begin() + std::ptrdiff_t(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
  }

  std::map<std::string, std::vector<double>> m_times;
};

}  // namespace

std::shared_ptr<const LightField> lightField(const std::optional<Block>& block) {
  static std::shared_ptr<LightField> field;
  static std::optional<Block> held{};
  if (field && held == block) return field;
  field.reset();  // before the next one takes as much again
  const LightFieldSize size{hogels, hogels, directions, directions};
  field = std::make_shared<LightField>(size, StoredType::uint8,
                                       block.value_or(LightField::blockFor(size)));
  held = block;
  parallelRows(hogels, [](int begin, int end) { fillRows(*field, begin, end); });
  return field;
}

RenderJob viewOf(int pose, const std::optional<Block>& block) {
  RenderJob job;
  job.lightField = lightField(block);
  job.display.hogels = {hogels, hogels};
  job.display.directions = {directions, directions};
  const double angle = 2 * std::numbers::pi * pose / poses;
  job.state.camera.eye = {0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.559};
  return job;
}

void countViews(benchmark::State& state, std::int64_t pixels) {
  state.SetItemsProcessed(std::int64_t(state.iterations()) * pixels);
  state.counters["views/s"] =
      benchmark::Counter(double(state.iterations()), benchmark::Counter::kIsRate);
}

void timeViews(benchmark::State& state, const std::function<RenderJob(int)>& make, int threads) {
  setThreads(threads);
  LensTables tables;
  const auto [width, height] = make(0).state.camera.res;
  Image image(width, height);
  (void)FastSimulation(make(0), tables, parallelRows);  // the table is warm
  int pose = 0;
  for (auto _ : state) {
    const FastSimulation simulation(make(pose++ % poses), tables, parallelRows);
    parallelRows(height, [&, width = width](int begin, int end) {
      const std::size_t first = std::size_t(width) * std::size_t(begin);
      simulation.rows(begin, end, 0, width, &image.rgb[3 * first], &image.seen[first]);
    });
    benchmark::DoNotOptimize(image.rgb.data());
  }
  countViews(state, std::int64_t(width) * height);
}

}  // namespace benchmarks

int main(int argc, char** argv) {
  using namespace benchmarks;
  takeFlag(argc, argv, "--hogels=", hogels);
  takeFlag(argc, argv, "--directions=", directions);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("processor", processorName());
  benchmark::AddCustomContext("kernels", std::string(kernelVersion()));
  addKernels();
  addLens();
  addViews();
  addLayouts();
  addOneThread();
  benchmark::AddCustomContext("lens table", lensTableForms());
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return 0;
}
