// SPDX-License-Identifier: BSD-3-Clause
// Units and lens sheets with errors as large as documents allow, pupils that may reach behind the
// panel, in scenes at the limits of the parameters.
#pragma once

#include "core/optics/session.h"
#include "tests/core/extreme_scene.h"
#include "tests/core/random_twin.h"

namespace extreme {

/// Returns an end of a range, 0, a number of any size in it, or one of its middle.
inline double anyOf(Random& random, double low, double high) {
  switch (random.integer(0, 5)) {
    case 0:
      return low;
    case 1:
      return high;
    case 2:
      return std::clamp(0.0, low, high);
    case 3: {
      const double size = anyScale(random, 1e-12, std::max({std::abs(low), high, 1e-11}));
      return std::clamp(random.flip() ? size : -size, low, high);
    }
    default:
      return random.uniform(low, high);
  }
}

inline hogelscope::TwinParams unitParams(Random& random, const hogelscope::PanelParams& display) {
  hogelscope::TwinParams twin = randomTwinParams(random, display);
  const auto any = [&](double low, double high) { return anyOf(random, low, high); };
  auto& array = twin.lensArray;
  if (random.flip()) array.offset = {any(-1, 1), any(-1, 1)};
  if (random.flip()) array.rotation = any(-45, 45);
  if (random.flip()) array.pitchError = {any(-0.5, 1), any(-0.5, 1)};
  if (random.flip()) array.gapError = any(-0.9, 9);
  if (random.flip()) array.wedge = {any(-0.9, 9), any(-0.9, 9)};
  if (random.flip()) array.focalError = any(-0.9, 9);
  if (random.flip()) twin.colour.scale = {any(-0.5, 0.5), any(-0.5, 0.5), any(-0.5, 0.5)};
  if (random.integer(0, 3) == 0) twin.leakage.sigmaGrowth = any(0, 100);
  if (random.integer(0, 3) == 0) twin.random.shift = {{any(0, 1), any(0, 9)}};
  return twin;
}

inline hogelscope::TwinMaps unitMaps(Random& random, const hogelscope::PanelParams& display) {
  hogelscope::TwinMaps maps = randomTwinMaps(random, display);
  const auto wild = [&](int width, int height, double limit) {
    hogelscope::TwinPlane plane{width, height, {}};
    for (int k = 0; k < width * height; ++k)
      plane.values.push_back(static_cast<float>(anyOf(random, -limit, limit)));
    return plane;
  };
  const auto [nx, ny] = display.hogels;
  for (auto* plane : {&maps.shiftX, &maps.shiftY, &maps.tiltX, &maps.tiltY, &maps.gap})
    if (random.integer(0, 3) == 0)
      *plane = wild(std::min(nx, 4), std::min(ny, 3), random.flip() ? 1 : 1e6);
  if (random.integer(0, 5) == 0)
    maps.height = wild(random.integer(1, 6), random.integer(1, 6), random.flip() ? 1 : 1e6);
  return maps;
}

/// Gives the scene a usual or, in a third of cases, an extreme unit. Throws InputError for one that
/// documents may not have either.
inline void addUnit(Random& random, RandomScene& scene) {
  if (random.integer(0, 2) > 0) return addTwin(random, scene);
  hogelscope::RenderJob& job = scene.job;
  hogelscope::TwinParams params = unitParams(random, job.display);
  hogelscope::TwinMaps maps = unitMaps(random, job.display);
  if (job.state.psf.light == hogelscope::LightModel::linear)
    addRandomLight(random, job.display, params, maps);
  if (job.sampling.reconstruction == hogelscope::Reconstruction::quadrilinear)
    job.sampling.reconstruction = hogelscope::Reconstruction::nearest;
  job.twin = std::make_shared<const hogelscope::Twin>(params, maps, job.display);
}

/// Returns a calibration whose numbers are any or, mostly, a usual display's.
inline hogelscope::SheetCalibration calibration(Random& random) {
  hogelscope::SheetCalibration sheet;
  const auto any = [&](double low, double high, double usualLow, double usualHigh) {
    return random.integer(0, 3) == 0 ? anyOf(random, low, high)
                                     : random.uniform(usualLow, usualHigh);
  };
  const double slope = any(-1e6, 1e6, 1, 9);
  sheet.params = {any(1e-3, 1e5, 5, 80),
                  random.flip() ? slope : -slope,
                  any(-1e6, 1e6, -5, 5),
                  any(1e-3, 1e6, 50, 400),
                  {random.integer(1, 40), random.integer(1, 40)},
                  any(0.01, 179.9, 10, 90)};
  sheet.pattern = random.integer(0, 4);
  if (random.flip()) {
    sheet.cells.clear();
    for (int kinds = random.integer(1, 3); kinds > 0; --kinds) {
      hogelscope::SubPixels cells;
      for (auto& place : cells) place = {random.uniform(-1, 1), random.uniform(-1, 1)};
      sheet.cells.push_back(cells);
    }
  }
  return sheet;
}

/// Replaces the display by a lens sheet. Throws InputError for one that documents may not have.
inline void addSheet(Random& random, RandomScene& scene) {
  hogelscope::RenderJob& job = scene.job;
  hogelscope::Session session;
  session.display = job.display;
  session.display.lens = hogelscope::HogelLensModel::rectilinear;
  hogelscope::SheetDisplay& sheet = session.display.sheet.emplace();
  sheet.calibration = calibration(random);
  // In half of the scenes as wide as the display, at which the camera looks.
  auto& params = sheet.calibration.params;
  if (random.flip())
    params.dpi = std::clamp(params.panel[0] * 0.0254 / job.display.size[0], 1e-3, 1e6);
  check(sheet.calibration.params);
  if (random.integer(0, 3) > 0)
    sheet.viewingDistance = random.flip() ? random.uniform(0.1, 3) : anyOf(random, 1e-3, 1e6);
  const double pixel = 0.0254 / sheet.calibration.params.dpi;
  if (random.integer(0, 3) == 0) sheet.spot = std::min(1e-3, random.uniform(0, 20) * pixel);
  session.lightField.layout = hogelscope::Layout::woven;
  const auto [width, height] = sheet.calibration.params.panel;
  scene.content.size = {width, height, 1, 1};
  session.display.size = hogelscope::LensSheet(sheet).size();
  job.display = resolved(displayOf(session), scene.content.size);
  job.sampling.reconstruction = hogelscope::Reconstruction::nearest;
  job.state.psf = {};
  fill(random, scene, [&] { return random.uniform(0, 255); });
}

/// Gives the state a pupil: an eye's, one that reaches behind the panel if the eye is near it, or
/// any.
inline void addPupil(Random& random, RandomScene& scene) {
  hogelscope::CameraState& state = scene.job.state;
  state.pupil.samples = random.integer(1, 9);
  const auto forward = state.camera.lookat - state.camera.eye;
  const double reach = std::hypot(forward.x, forward.y, forward.z);
  state.pupil.diameter =
      random.flip() ? 0.004 : std::clamp(reach * random.uniform(0, 4), 1e-4, 1.0);
  if (random.integer(0, 3) == 0) state.pupil.diameter = anyOf(random, 1e-4, 1);
  if (random.integer(0, 3) > 0) state.pupil.focus = std::max(1e-3, anyOf(random, 1e-3, 1e6));
}

/// Returns a scene with a unit or a lens sheet. Throws InputError as these do.
inline RandomScene unitScene(Random& random, bool hasSheet) {
  RandomScene made;
  do {
    made = scene(random, static_cast<Eye>(random.integer(0, 7)));
  } while (std::ranges::max(made.job.display.hogels) > 100);  // whose errors take long to draw
  if (hasSheet)
    addSheet(random, made);
  else
    addUnit(random, made);
  if (random.flip()) addPupil(random, made);
  return made;
}

}  // namespace extreme
