// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/sampling.h"

namespace hogelscope {

namespace {
constexpr std::array<std::string_view, 2> mappingNames{"exact", "direct"};
constexpr std::array<std::string_view, 3> reconstructionNames{"nearest", "bilinear",
                                                              "quadrilinear"};
}  // namespace

void describe(ParameterVisitor& v, SamplingParams& p) {
  auto& [mapping, reconstruction, samplesPerPixel, tolerance] = p;
  v.group("sampling", "How the simulated view is taken.");
  v.field({"mapping", "Lens mapping"}, mapping, mappingNames,
          "Lens: exact inverts the distortion, as a real camera; direct applies it, as the paper.");
  v.field("reconstruction", reconstruction, reconstructionNames,
          "The display's exact pixels, or interpolated between directions, or between hogels too.");
  v.field({"samplesPerPixel", "Rays a pixel, n × n"}, samplesPerPixel, {1, 64, 1, false, 1, 8}, "",
          "n takes n×n rays in each pixel; rays that see nothing count as black.");
  v.field("tolerance", tolerance, {0, 100, 0.1, false, 0, 10}, "code values",
          "RMS error that a cheaper method may have; 0: no other method is used.");
}

std::vector<RaySample> samplesOf(int n, std::size_t points) {
  std::vector<RaySample> samples;
  for (std::size_t point = 0; point < points; ++point)
    for (int k = 0; k < n * n; ++k) {
      const int row = k / n;
      samples.push_back({k, {(k % n + 0.5) / n, (row + 0.5) / n}, point});
    }
  return samples;
}

std::string_view nameOf(Reconstruction reconstruction) {
  return reconstructionNames[static_cast<std::size_t>(reconstruction)];
}

}  // namespace hogelscope
