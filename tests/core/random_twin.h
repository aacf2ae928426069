// SPDX-License-Identifier: BSD-3-Clause
// Random twins for tests of the simulation.
#pragma once

#include "core/panel/twin.h"
#include "tests/core/random_scene.h"

inline hogelscope::TwinPlane randomPlane(Random& random, int width, int height, double least,
                                         double most) {
  hogelscope::TwinPlane plane{width, height, {}};
  for (int k = 0; k < width * height; ++k)
    plane.values.push_back(static_cast<float>(random.uniform(least, most)));
  return plane;
}

/// Each part is as designed in half of the twins.
inline hogelscope::TwinParams randomTwinParams(Random& random,
                                               const hogelscope::PanelParams& display) {
  hogelscope::TwinParams twin;
  twin.maps.kernelTiles = 2;
  const double pitch =
      std::min(display.size[0] / display.hogels[0], display.size[1] / display.hogels[1]);
  const auto both = [&](double limit) {
    return std::array{random.uniform(-limit, limit), random.uniform(-limit, limit)};
  };
  auto& array = twin.lensArray;
  if (random.flip()) array.offset = both(0.4 * pitch);
  if (random.flip()) array.rotation = random.uniform(-3, 3);
  if (random.flip()) array.pitchError = both(0.02);
  if (random.flip()) array.gapError = random.uniform(-0.1, 0.1);
  if (random.flip()) array.wedge = both(0.1);
  if (random.flip()) array.focalError = random.uniform(-0.1, 0.1);
  if (random.flip()) array.outside = hogelscope::OutsideField::neighbour;
  if (random.flip())
    twin.colour.scale = {random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05),
                         random.uniform(-0.05, 0.05)};
  if (random.flip()) twin.random.shift.sigma = 0.1 * pitch;
  if (random.flip()) twin.random.shift.length = random.uniform(0, 4);
  twin.random.seed = random.integer(0, 1000);
  if (random.integer(0, 3) == 0) twin.leakage.sigmaGrowth = random.uniform(0, 2);
  if (random.integer(0, 3) == 0)
    twin.colour.wavelengths = {random.uniform(0.1, 0.3) * pitch, 0,
                               random.uniform(0.1, 0.2) * pitch};
  if (random.integer(0, 3) == 0) {
    const auto [nx, ny] = display.hogels;
    const auto [du, dv] = display.directions;
    for (int k = 0; k < 5; ++k) {
      twin.dead.rows.push_back(random.integer(0, ny * dv - 1));
      twin.dead.columns.push_back(random.integer(0, nx * du - 1));
      twin.dead.hogels.push_back({random.integer(0, nx - 1), random.integer(0, ny - 1)});
    }
  }
  return twin;
}

inline hogelscope::TwinMaps randomTwinMaps(Random& random, const hogelscope::PanelParams& display) {
  hogelscope::TwinMaps maps;
  const auto [nx, ny] = display.hogels;
  const auto [du, dv] = display.directions;
  const double pitch = std::min(display.size[0] / nx, display.size[1] / ny);
  const auto plane = [&](int width, int height, double limit) {
    return randomPlane(random, width, height, -limit, limit);
  };
  if (random.flip()) maps.shiftX = plane(nx, ny, 0.2 * pitch);
  if (random.flip()) maps.shiftY = plane(nx, ny, 0.2 * pitch);
  if (random.flip()) maps.tiltX = plane(2, 3, 0.05);  // coarser
  if (random.flip()) maps.tiltY = plane(nx, ny, 0.05);
  if (random.flip()) maps.gap = plane(nx, ny, 0.05);
  if (random.flip()) maps.moveU = plane(du, dv, 0.2);
  if (random.flip()) maps.moveV = plane(du, dv, 0.2);
  if (random.integer(0, 3) == 0) maps.sigma = randomPlane(random, 3, 2, 0.4, 2);
  if (random.integer(0, 7) == 0)
    for (auto& kernels : maps.kernels) kernels = randomPlane(random, 6, 6, 0, 1);
  if (random.integer(0, 3) == 0) maps.height = plane(6, 5, 0.002 * display.size[0]);
  return maps;
}

/// Adds what scales and adds light.
inline void addRandomLight(Random& random, const hogelscope::PanelParams& display,
                           hogelscope::TwinParams& twin, hogelscope::TwinMaps& maps) {
  auto& light = twin.light;
  if (random.flip()) light.black = random.uniform(0, 0.05);
  if (random.flip())
    light.ambient = {random.uniform(0, 0.1), random.uniform(0, 0.1), random.uniform(0, 0.1)};
  if (random.flip()) light.falloff = random.uniform(0, 4);
  if (random.flip()) light.fill = {random.uniform(0.5, 1), random.uniform(0.5, 1)};
  if (random.flip()) light.bits = random.integer(2, 10);
  if (random.flip()) light.eotf = hogelscope::Eotf(random.integer(0, 3));
  if (random.flip()) twin.random.gain = {{0.1, random.uniform(0, 3)}};
  const auto [nx, ny] = display.hogels;
  const auto [du, dv] = display.directions;
  for (std::size_t c = 0; c < 3; ++c) {
    if (random.flip()) maps.gain[c] = randomPlane(random, nx, ny, 0.5, 1.2);
    if (random.flip()) maps.directionGain[c] = randomPlane(random, du, dv, 0.5, 1.2);
  }
}

/// Gives the scene a twin, that scales light too if psf.light is linear.
inline void addTwin(Random& random, RandomScene& scene) {
  hogelscope::TwinParams params = randomTwinParams(random, scene.job.display);
  hogelscope::TwinMaps maps = randomTwinMaps(random, scene.job.display);
  if (scene.job.state.psf.light == hogelscope::LightModel::linear)
    addRandomLight(random, scene.job.display, params, maps);
  if (scene.job.sampling.reconstruction == hogelscope::Reconstruction::quadrilinear)
    scene.job.sampling.reconstruction = hogelscope::Reconstruction::nearest;
  scene.job.twin = std::make_shared<const hogelscope::Twin>(params, maps, scene.job.display);
}
