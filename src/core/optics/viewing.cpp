// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/viewing.h"

#include <cmath>
#include <numbers>

#include "core/optics/simulate.h"

namespace hogelscope {

namespace {

double determinant(const Jacobian& j) {
  return j.xx * j.yy - j.xy * j.yx;
}

/// Returns Viewing::pixelsPerDegree: the lens stretches a pixel's area on the sensor, which the eye
/// sees as a solid angle.
double pixelsPerDegree(const CameraState& state, LensMapping mapping) {
  const Camera camera(state.camera, state.intrinsics);
  const Distortion lens(state.distortion);
  const auto [width, height] = state.camera.res;
  const Vec2 onSensor = camera.normalised((width - 1) / 2.0, (height - 1) / 2.0);
  const auto ideal = idealPoint(lens, mapping, onSensor);
  if (!ideal) return std::numeric_limits<double>::quiet_NaN();
  const double stretch = mapping == LensMapping::exact ? 1 / determinant(lens.jacobian(*ideal))
                                                       : determinant(lens.jacobian(onSensor));
  const double r = std::hypot(ideal->x, ideal->y, 1.0);
  const double solidAngle =
      std::abs(stretch) / (camera.focalLength().x * camera.focalLength().y * r * r * r);
  return std::numbers::pi / 180 / std::sqrt(solidAngle);
}

}  // namespace

Viewing viewingOf(const CameraState& state, const DisplayParams& display, LensMapping mapping) {
  return {pixelsPerDegree(state, mapping), length(state.camera.eye - display.position),
          state.camera.name};
}

}  // namespace hogelscope
