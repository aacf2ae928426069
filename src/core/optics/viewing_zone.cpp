// SPDX-License-Identifier: BSD-3-Clause
// The display's viewing zone.
#include "core/optics/viewing_zone.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

/// Returns the share of a side of the panel, centred on 0, that lies within `reach` of `at`.
double shareWithin(double side, double at, double reach) {
  const double from = std::max(at - reach, -side / 2);
  const double to = std::min(at + reach, side / 2);
  return std::max(0.0, to - from) / side;
}

}  // namespace

/// A point (x, y) of the panel lights p where |p.x - x| ≤ p.z·tan(fov/2), and likewise in y: both
/// lenses end at the same slope, and the two axes are independent.
double shareSeenFrom(const DisplayParams& display, const Vec3& point) {
  const Vec3 p = transformFromPose(display.position, display.orientation).inverse().point(point);
  if (!(p.z > 0)) return 0;
  const auto reach = [&](double fov) { return p.z * std::tan(radians(fov) / 2); };
  return shareWithin(display.size[0], p.x, reach(display.fov[0])) *
         shareWithin(display.size[1], p.y, reach(display.fov[1]));
}

}  // namespace hogelscope
