// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/design_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hogelscope {

namespace {

double degrees(double radians) {
  return radians * (180 / std::numbers::pi);
}

}  // namespace

DesignNumbers designNumbers(const PanelParams& display, const Vec3& eye) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  DesignNumbers numbers;
  numbers.megapixels =
      1e-6 * display.hogels[0] * display.hogels[1] * display.directions[0] * display.directions[1];
  const double distance =
      transformFromPose(display.position, display.orientation).inverse().point(eye).z;
  numbers.distance = std::max(distance, 0.0);
  double depth = infinite;  // p/s, where the narrowest direction is as wide as a hogel
  for (const std::size_t axis : {0, 1}) {
    const double half = 0.5 / display.directions[axis];
    const auto lens = lensOf(display, axis);
    const double high = lens->slopeOf(half);
    const double low = lens->slopeOf(-half);
    const double pitch = display.size[axis] / display.hogels[axis];
    const double step = high - low;
    numbers.hogelPitch[axis] = pitch;
    numbers.slopeStep[axis] = step;
    numbers.degreesPerDirection[axis] = degrees(std::atan(high) - std::atan(low));
    if (display.directions[axis] > 1) depth = std::min(depth, pitch / step);
    if (!(distance > 0)) continue;
    numbers.hogelArcmin[axis] = 60 * degrees(2 * std::atan(pitch / (2 * distance)));
    numbers.directionsPerPupil[axis] = designPupil / (distance * step);
  }
  if (!(distance > 0)) return numbers;
  // p D/(s D ± p), divided by s
  numbers.depthFront = depth == infinite ? distance : depth * distance / (distance + depth);
  numbers.depthBehind = distance <= depth ? infinite : depth * distance / (distance - depth);
  return numbers;
}

double dioptresAt(double z, double distance) {
  return 1 / (distance - z) - 1 / distance;
}

void holdPitch(const DisplayParams& before, DisplayParams& after) {
  for (const std::size_t axis : {0, 1})
    if (before.hogels[axis] > 0 && after.hogels[axis] > 0)
      after.size[axis] *= double(after.hogels[axis]) / before.hogels[axis];
}

void holdPixels(const DisplayParams& before, DisplayParams& after) {
  const auto edited =
      after.hogels != before.hogels ? &DisplayParams::hogels : &DisplayParams::directions;
  const auto other =
      edited == &DisplayParams::hogels ? &DisplayParams::directions : &DisplayParams::hogels;
  for (const std::size_t axis : {0, 1}) {
    const int was = (before.*edited)[axis];
    const int is = (after.*edited)[axis];
    int& count = (after.*other)[axis];
    if (was < 1 || is < 1 || (other == &DisplayParams::directions && count == 1)) continue;
    count = std::max(1, int(std::lround(double(count) * was / is)));
  }
}

}  // namespace hogelscope
