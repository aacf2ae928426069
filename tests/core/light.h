// SPDX-License-Identifier: BSD-3-Clause
// Unrounded images of either engine, and their comparison.
#pragma once

#include <QString>

#include "core/engine/fast_simulation.h"
#include "tests/core/extreme_scene.h"

/// Code values and mask, rows from the top.
struct Light {
  std::vector<double> rgb;
  std::vector<std::uint8_t> seen;
  bool operator==(const Light&) const = default;
};

inline Light referenceLight(const hogelscope::RenderJob& job) {
  const hogelscope::Simulation simulation(job);
  const auto [width, height] = job.state.camera.res;
  Light light;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::optional<hogelscope::Rgb> colour = simulation.pixel(x, y);
      const auto [r, g, b] = colour.value_or(hogelscope::Rgb{});
      light.rgb.insert(light.rgb.end(), {r, g, b});
      light.seen.push_back(colour ? 255 : 0);
    }
  }
  return light;
}

inline Light fastLight(const hogelscope::RenderJob& job) {
  hogelscope::LensTables tables;
  const hogelscope::FastSimulation simulation(job, tables, hogelscope::serialRows);
  const auto [width, height] = job.state.camera.res;
  constexpr std::uint8_t notWritten = 77;
  Light light;
  light.seen.assign(std::size_t(width) * std::size_t(height), notWritten);
  std::vector<float> rgb(3 * light.seen.size(), notWritten);
  simulation.rows(0, height, 0, width, rgb.data(), light.seen.data());
  light.rgb.assign(rgb.begin(), rgb.end());
  return light;
}

/// The place and kind of a problem in an image, or "".
using Problem = QString;

inline Problem problemAt(const char* what, std::size_t pixel, const hogelscope::RenderJob& job,
                         double value) {
  const int width = job.state.camera.res[0];
  return QString("%1 at (%2, %3): %4")
      .arg(what)
      .arg(int(pixel) % width)
      .arg(int(pixel) / width)
      .arg(value, 0, 'g', 17);
}

/// Compares light and mask, except for pixels with a ray so near to a cell's border that rounding
/// decides; these are counted.
inline Problem difference(const RandomScene& scene, const Light& expected, const Light& found,
                          int& unclear) {
  const auto& job = scene.job;
  const bool interpolates = job.sampling.reconstruction != hogelscope::Reconstruction::nearest;
  std::array<double, 4> margin = extreme::rounding(job);
  double change = 1e-3;
  for (double& cells : margin) {
    if (interpolates) change += 2 * 255 * cells;
    cells += 1e-4;
  }
  const brute::Simulator rays(job, scene.content, margin);
  for (std::size_t pixel = 0; pixel < expected.seen.size(); ++pixel) {
    double most = 0;
    for (std::size_t k = 3 * pixel; k < 3 * pixel + 3; ++k)
      most = std::max(most, std::abs(expected.rgb[k] - found.rgb[k]));
    if (expected.seen[pixel] == found.seen[pixel] && most <= change) continue;
    const int width = job.state.camera.res[0];
    if (!rays.isUnclear(int(pixel) % width, int(pixel) / width))
      return problemAt("differs", pixel, job, most);
    ++unclear;
  }
  return {};
}
