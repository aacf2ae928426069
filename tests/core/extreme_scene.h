// SPDX-License-Identifier: BSD-3-Clause
// Random scenes at the limits of the parameters, and the effect of rounding on their rays.
#pragma once

#include "tests/core/random_scene.h"

namespace extreme {

/// The position of the eye and its view of the panel.
enum class Eye { usual, close, distant, inPlane, behind, grazing, parallel, away };

/// Returns a random number of [min, max], uniform in its logarithm.
inline double anyScale(Random& random, double min, double max) {
  return min * std::pow(max / min, random.uniform(0, 1));
}

/// Returns an end of a range or a usual value with equal probability.
inline double pick(Random& random, double usual, double low, double high) {
  return random.flip() ? usual : random.flip() ? low : high;
}

inline hogelscope::PanelParams display(Random& random) {
  hogelscope::PanelParams display = randomDisplay(random);
  for (double& fov : display.fov) fov = pick(random, fov, 0.01, 179.9);
  if (random.flip())
    for (double& size : display.size) size = anyScale(random, 1e-6, 1e6);
  if (random.integer(0, 3) == 0)
    for (double* angle : {&display.orientation.x, &display.orientation.y, &display.orientation.z})
      *angle = 90 * random.integer(-4, 4);
  constexpr int longest = 1 << 15;
  switch (random.integer(0, 31)) {
    case 0:
      display.hogels = {longest, 1};
      display.directions = {random.integer(1, 2), random.integer(1, 2)};
      break;
    case 1:
      display.hogels = {1, longest};
      display.directions = {1, random.integer(1, 3)};
      break;
    case 2:
    case 3:
      display.hogels = {1, 1};
      break;
    case 4:
    case 5:
      display.directions = {1, 1};
      break;
    default:
      break;
  }
  return display;
}

inline hogelscope::DistortionParams lens(Random& random) {
  const int kind = random.integer(0, 3);
  if (kind == 0) return randomLens(random);
  if (kind > 1) return {};
  const auto k = [&] { return pick(random, random.uniform(-10, 10), -10, 10); };
  return {k(), k(), k(), k(), k()};
}

inline hogelscope::PsfParams psf(Random& random) {
  hogelscope::PsfParams psf = randomPsf(random);
  if (random.flip()) psf.windowSize = random.flip() ? 1 : 2 * random.integer(0, 49) + 1;
  psf.sigma = pick(random, psf.sigma, anyScale(random, 1e-300, 1), 20);
  return psf;
}

inline hogelscope::SamplingParams sampling(Random& random) {
  return {static_cast<hogelscope::LensMapping>(random.integer(0, 1)),
          static_cast<hogelscope::Reconstruction>(random.integer(0, 2)),
          random.integer(0, 3) > 0 ? 1 : random.integer(2, 4)};
}

inline bool isInverted(const hogelscope::RenderJob& job) {
  return job.sampling.mapping == hogelscope::LensMapping::exact &&
         job.state.distortion != hogelscope::DistortionParams{};
}

/// Returns the reference's work for one pixel: taps, and for a lens' inverse the equivalent of 300.
inline int workOf(const hogelscope::RenderJob& job) {
  const auto& [mapping, reconstruction, samples, tolerance] = job.sampling;
  const int corners = 1 << 2 * static_cast<int>(reconstruction);
  const int decoding = job.state.psf.light == hogelscope::LightModel::linear ? 4 : 1;
  const int window = job.state.psf.windowSize;
  return samples * samples * (corners * window * window * decoding + (isInverted(job) ? 300 : 0));
}

/// Limits the image to 24 × 24 pixels, or one row longer than a batch, so that the reference is
/// fast.
inline void limitWork(Random& random, hogelscope::RenderJob& job) {
  constexpr int most = 20000;
  auto& window = job.state.psf.windowSize;
  while (workOf(job) > most && window > 1) window = window / 2 | 1;
  const int pixels = std::max(most / workOf(job), 1);
  const int width = random.integer(0, 15) == 0 ? random.integer(129, 300) : random.integer(1, 24);
  const int height = width > 24 ? 1 : random.integer(1, 24);
  job.state.camera.res[0] = std::min(width, pixels);
  job.state.camera.res[1] = std::clamp(pixels / width, 1, height);
}

/// An eye and its look-at point in the display frame; the panel's size from there, as a slope.
struct Look {
  brute::Vector eye, lookat;
  double extent;
};

inline double distanceOf(Random& random, const hogelscope::PanelParams& display, Eye kind) {
  const auto [width, height] = display.size;
  if (kind == Eye::close) return anyScale(random, 1e-9, 1e-3);
  if (kind == Eye::distant) return anyScale(random, 1, 1e6);
  if (kind == Eye::inPlane) return 0;
  if (kind == Eye::behind) return -anyScale(random, 1e-9, 0.1) * (1 + width + height);
  return random.uniform(0.3, 3) * std::max(width, height);
}

/// Returns a grazing eye's direction: along the panel, and slightly or not at all towards it.
inline brute::Vector along(Random& random, double descent) {
  const double turn = random.uniform(0, 360) * brute::degree;
  return {std::cos(turn), std::sin(turn), -descent};
}

/// Returns a look at a point of the panel, from within its angular field.
inline Look look(Random& random, const hogelscope::PanelParams& display, Eye kind) {
  const bool isSteep = kind == Eye::grazing;
  const auto slope = [&](double fov) {
    const double end = random.uniform(isSteep ? 0.99 : -1, 1);
    return std::tan(end * fov / 2 * brute::degree);
  };
  const double a = slope(display.fov[0]);
  const double b = slope(display.fov[1]);
  const double farthest =
      (9e5 - std::max(display.size[0], display.size[1]) / 2) / (1 + std::hypot(a, b));
  const double z = std::clamp(distanceOf(random, display, kind), -farthest, farthest);
  const brute::Vector eye{random.uniform(-0.3, 0.3) * display.size[0] + z * a,
                          random.uniform(-0.3, 0.3) * display.size[1] + z * b, z};
  brute::Vector forward{-a, -b, -1};
  if (isSteep && random.flip()) forward = along(random, anyScale(random, 1e-12, 1e-2));
  if (kind == Eye::parallel) forward = along(random, 0);
  if (kind == Eye::away) forward = {0, 0, 1};
  const double reach = random.flip() ? std::max(std::abs(z), 1e-3) : 1;
  const std::size_t axis = random.flip() ? 1 : 0;
  const double extent = std::min(display.size[axis] / std::max(std::abs(z), 1e-9),
                                 2 * std::tan(display.fov[axis] / 2 * brute::degree));
  return {eye,
          {eye[0] + reach * forward[0], eye[1] + reach * forward[1], eye[2] + reach * forward[2]},
          kind == Eye::parallel ? 10 : extent / (1 + a * a + b * b)};
}

/// Transforms a point from the display frame to the world, limited to the range of documents.
inline hogelscope::Vec3 inWorld(const hogelscope::PanelParams& display, const brute::Vector& p) {
  const brute::Vector turned = brute::times(brute::rotation(display.orientation), p);
  const auto limited = [](double metres) { return std::clamp(metres, -1e6, 1e6); };
  return {limited(turned[0] + display.position.x), limited(turned[1] + display.position.y),
          limited(turned[2] + display.position.z)};
}

/// Returns a vertical field of view: any, or about as wide as the visible part of the panel.
inline double fieldOf(Random& random, const Look& at) {
  const double any = pick(random, random.uniform(10, 70), 0.01, 179.9);
  const double fitting = 2 * std::atan(at.extent * random.uniform(0.1, 1)) / brute::degree;
  return random.integer(0, 3) == 0 ? any : std::clamp(fitting, 0.01, 179.9);
}

/// Returns no intrinsics, or about those of the field of view, with a small or very large shift.
inline hogelscope::IntrinsicsParams intrinsics(Random& random,
                                               const hogelscope::CameraParams& camera) {
  if (random.integer(0, 2) > 0) return {};
  const double focal = camera.res[1] / 2.0 / std::tan(camera.fov / 2 * brute::degree);
  hogelscope::IntrinsicsParams given;
  given.fx = random.integer(0, 3) > 0 ? std::max(focal, 1e-3) : pick(random, 1, 1e-3, 1e8);
  if (random.flip()) given.fy = std::max(given.fx * random.uniform(0.5, 1), 1e-3);
  const auto centre = [&](int pixels) {
    const double near = random.integer(0, 2 * pixels) / 2.0;
    return random.integer(0, 3) > 0 ? near : pick(random, near, -1e6, 1e6);
  };
  if (random.flip()) given.cx = centre(camera.res[0]);
  if (random.flip()) given.cy = centre(camera.res[1]);
  return given;
}

/// Returns a scene without its light field.
inline RandomScene sceneWithoutLight(Random& random, Eye kind) {
  RandomScene scene;
  auto& [lightField, panel, sampled, state, method, isIdeal, bits, keepsUnrounded, twin] =
      scene.job;
  panel = display(random);
  // Without rotation, an eye is exactly in the plane, or a ray exactly parallel to it.
  if (kind == Eye::inPlane || kind == Eye::parallel) panel.orientation = {};
  if (kind == Eye::grazing || (kind == Eye::parallel && random.flip())) panel.fov = {179.9, 179.9};
  const Look at = look(random, panel, kind);
  // Only here, because so far from the origin rounding decides what is behind the panel.
  if (kind == Eye::distant && random.flip()) panel.position.x = random.uniform(-1e5, 1e5);
  state.camera.name = "extreme";
  state.camera.eye = inWorld(panel, at.eye);
  state.camera.lookat = inWorld(panel, at.lookat);
  state.camera.up = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  state.camera.fov = fieldOf(random, at);
  state.distortion = lens(random);
  state.psf = psf(random);
  sampled = sampling(random);
  limitWork(random, scene.job);
  state.intrinsics = intrinsics(random, state.camera);
  scene.content.size = {panel.hogels[0], panel.hogels[1], panel.directions[0], panel.directions[1]};
  return scene;
}

/// Stores `codeValue()` for each channel of each texel as T; `steps` is the T value of one code
/// value.
template <class T, class CodeValue>
void store(RandomScene& scene, double steps, CodeValue codeValue) {
  const auto& size = scene.content.size;
  std::vector<T> values(3 * size.width() * size.height());
  for (T& value : values) value = static_cast<T>(steps * codeValue());
  scene.job.lightField = std::make_shared<hogelscope::LightField>(size, std::move(values));
}

/// Stores the values in a random one of the stored types.
template <class CodeValue>
void fill(Random& random, RandomScene& scene, CodeValue codeValue) {
  const int type = random.integer(0, 2);
  if (type == 0) return store<std::uint8_t>(scene, 1, codeValue);
  if (type == 1) return store<std::uint16_t>(scene, 257, codeValue);
  store<float>(scene, 1 / 255.0, codeValue);
}

/// Returns a scene of noise, or of a few bright texels in the dark, which leak the most.
inline RandomScene scene(Random& random, Eye kind) {
  RandomScene made = sceneWithoutLight(random, kind);
  if (random.flip())
    fill(random, made, [&] { return random.uniform(0, 255); });
  else
    fill(random, made, [&] { return random.integer(0, 9) == 0 ? 255.0 : 0.0; });
  return made;
}

/// Returns the largest effect of rounding on the real-valued i, j, u, v of a ray within the angular
/// field.
inline std::array<double, 4> rounding(const hogelscope::RenderJob& job) {
  constexpr double epsilon = 0x1p-52;
  const auto& display = job.display;
  const auto norm = [](const hogelscope::Vec3& a) { return std::hypot(a.x, a.y, a.z); };
  const double field = std::max(display.fov[0], display.fov[1]);
  const double steepest = 1 + std::tan(field / 2 * brute::degree);
  // A root of the lens model has an error of 1 / det J; below 1e-3 the oracle calls it unclear.
  const double slope = 4 * epsilon * steepest * steepest * (isInverted(job) ? 1e3 : 1);
  const hogelscope::Vec3& eye = job.state.camera.eye;
  const double place = norm(eye - display.position) * slope +
                       4 * epsilon * (norm(eye) + norm(display.position)) * steepest;
  return {place / display.size[0] * display.hogels[0], place / display.size[1] * display.hogels[1],
          slope / (display.fov[0] * brute::degree) * display.directions[0],
          slope / (display.fov[1] * brute::degree) * display.directions[1]};
}

}  // namespace extreme
