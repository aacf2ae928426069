// SPDX-License-Identifier: BSD-3-Clause
// The display's viewing zone.
#include "core/optics/viewing_zone.h"

#include <algorithm>

namespace hogelscope {

namespace {

/// Returns the share of a side of the panel, centred on 0, whose light reaches a point at `at`, z
/// in front of it: of the places x with (at - x)/z + convergence·x within the lens' field.
double shareWithin(double side, double at, double z, double convergence, const HogelLens& lens) {
  const double low = at - z * lens.slopeOf(0.5);  // ≤ x·(1 - z·convergence) ≤ high
  const double high = at - z * lens.slopeOf(-0.5);
  const double scale = 1 - z * convergence;
  if (scale == 0) return low <= 0 && 0 <= high ? 1 : 0;
  const double from = std::max(std::min(low / scale, high / scale), -side / 2);
  const double to = std::min(std::max(low / scale, high / scale), side / 2);
  return std::max(0.0, to - from) / side;
}

}  // namespace

/// The two axes are independent.
double shareSeenFrom(const DisplayParams& display, const Vec3& point) {
  const Vec3 p = transformFromPose(display.position, display.orientation).inverse().point(point);
  if (!(p.z > 0)) return 0;
  const double distance = display.viewingDistance;
  const double convergence = distance > 0 ? 1 / distance : 0;
  return shareWithin(display.size[0], p.x, p.z, convergence, *lensOf(display, 0)) *
         shareWithin(display.size[1], p.y, p.z, convergence, *lensOf(display, 1));
}

}  // namespace hogelscope
