// SPDX-License-Identifier: BSD-3-Clause
// Random scenes for tests of the simulation: a display with noise on it, and a camera before it.
#pragma once

#include <memory>

#include "tests/core/brute_force.h"
#include "tests/core/random.h"

struct RandomScene {
  hogelscope::RenderJob job;
  brute::Content content;
};

/// Fills with noise stored as T; `codeValue` is the code value of one step of T.
template <class T>
void fillWithNoise(Random& random, RandomScene& scene, double min, double max, double codeValue) {
  const auto& size = scene.content.size;
  std::vector<T> values(3 * size.width() * size.height());
  for (T& value : values) value = static_cast<T>(random.uniform(min, max));
  for (const T value : values) scene.content.codes.push_back(double(value) * codeValue);
  scene.job.lightField = std::make_shared<hogelscope::LightField>(size, std::move(values));
}

inline void fillWithNoise(Random& random, RandomScene& scene) {
  switch (random.integer(0, 2)) {
    case 0:
      return fillWithNoise<std::uint8_t>(random, scene, 0, 256, 1);
    case 1:
      return fillWithNoise<std::uint16_t>(random, scene, 0, 65536, 1 / 257.0);
    // Floating content may exceed the range of an image.
    default:
      return fillWithNoise<float>(random, scene, -0.1, 1.2, 255);
  }
}

/// Replaces the content by noise for the display's hogels and directions.
inline void fillDisplay(Random& random, RandomScene& scene) {
  const auto& [hogels, directions] =
      std::pair(scene.job.display.hogels, scene.job.display.directions);
  scene.content = {{hogels[0], hogels[1], directions[0], directions[1]}, {}};
  fillWithNoise(random, scene);
}

inline hogelscope::PanelParams randomDisplay(Random& random) {
  hogelscope::PanelParams display;
  display.position = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
  display.orientation = {random.uniform(-180, 180), random.uniform(-180, 180),
                         random.uniform(-180, 180)};
  display.size = {random.uniform(0.05, 1), random.uniform(0.05, 1)};
  display.hogels = {random.integer(1, 9), random.integer(1, 9)};
  display.directions = {random.integer(1, 9), random.integer(1, 9)};
  display.fov = {random.uniform(10, 170), random.uniform(10, 170)};
  display.lens = random.flip() ? hogelscope::HogelLensModel::rectilinear
                               : hogelscope::HogelLensModel::equiangular;
  if (random.integer(0, 3) == 0) display.viewingDistance = random.uniform(0.2, 3);
  return display;
}

/// Returns a camera that looks at a point of the panel from inside that point's angular field.
inline hogelscope::CameraParams randomCamera(Random& random,
                                             const hogelscope::PanelParams& display) {
  const auto& [width, height] = display.size;
  const auto slope = [&](double fov) {
    return random.uniform(-0.6, 0.6) * std::min(std::tan(fov / 2 * brute::degree), 1.5);
  };
  const brute::Vector target{random.uniform(-0.3, 0.3) * width, random.uniform(-0.3, 0.3) * height,
                             random.uniform(-0.05, 0.05)};
  const double z = random.uniform(0.3, 3) * std::max(width, height) + 0.05;
  const double turn = display.viewingDistance > 0 ? 1 / display.viewingDistance : 0;
  const brute::Vector eye{target[0] + z * (slope(display.fov[0]) - turn * target[0]),
                          target[1] + z * (slope(display.fov[1]) - turn * target[1]), z};
  const brute::Matrix rotation = brute::rotation(display.orientation);
  const auto world = [&](const brute::Vector& p) {
    const brute::Vector turned = brute::times(rotation, p);
    return hogelscope::Vec3{turned[0] + display.position.x, turned[1] + display.position.y,
                            turned[2] + display.position.z};
  };
  hogelscope::CameraParams camera;
  camera.eye = world(eye);
  camera.lookat = world(target);
  camera.up = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  camera.fov = random.uniform(10, 70);
  camera.res = {random.integer(20, 28), random.integer(15, 21)};
  return camera;
}

/// Returns no intrinsics, or some near those of the field of view.
inline hogelscope::IntrinsicsParams randomIntrinsics(Random& random,
                                                     const hogelscope::CameraParams& camera) {
  if (random.integer(0, 2) > 0) return {};
  hogelscope::IntrinsicsParams intrinsics;
  intrinsics.fx = camera.res[1] * random.uniform(0.7, 4);
  if (random.flip()) intrinsics.fy = intrinsics.fx * random.uniform(0.5, 2);
  if (random.flip()) intrinsics.cx = random.uniform(0, camera.res[0]);
  if (random.flip()) intrinsics.cy = random.uniform(-3, camera.res[1]);
  return intrinsics;
}

inline hogelscope::DistortionParams randomLens(Random& random) {
  if (random.integer(0, 4) == 0) return {};
  const auto k = [&](double limit) { return random.uniform(-limit, limit); };
  hogelscope::DistortionParams lens{k(0.8), k(0.8), k(0.2), k(0.2), k(0.8)};
  if (const int kind = random.integer(0, 3); kind == 0) {
    lens.model = hogelscope::DistortionModel::rational;
    lens.k4 = k(0.8), lens.k5 = k(0.8), lens.k6 = k(0.8);
  } else if (kind == 1) {
    lens.model = hogelscope::DistortionModel::fisheye;
    lens.p1 = lens.p2 = 0;
    lens.k4 = k(0.8);
  }
  return lens;
}

inline hogelscope::PsfParams randomPsf(Random& random) {
  return {random.uniform(0.3, 3), 2 * random.integer(0, 4) + 1,
          static_cast<hogelscope::PsfBorder>(random.integer(0, 2)),
          static_cast<hogelscope::LightModel>(random.integer(0, 1))};
}

inline RandomScene randomScene(Random& random) {
  RandomScene scene;
  scene.job.display = randomDisplay(random);
  const hogelscope::CameraParams camera = randomCamera(random, scene.job.display);
  scene.job.state.camera = camera;
  scene.job.state.intrinsics = randomIntrinsics(random, camera);
  scene.job.state.distortion = randomLens(random);
  scene.job.state.psf = randomPsf(random);
  scene.job.sampling.mapping =
      random.flip() ? hogelscope::LensMapping::exact : hogelscope::LensMapping::direct;
  fillDisplay(random, scene);
  return scene;
}

/// Returns a scene with any reconstruction, in a quarter of cases with several rays per pixel.
inline RandomScene randomSampledScene(Random& random) {
  RandomScene scene = randomScene(random);
  scene.job.sampling.reconstruction = static_cast<hogelscope::Reconstruction>(random.integer(0, 2));
  scene.job.sampling.samplesPerPixel = random.integer(0, 3) == 0 ? 2 : 1;
  return scene;
}
