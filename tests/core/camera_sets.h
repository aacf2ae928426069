// SPDX-License-Identifier: BSD-3-Clause
// Camera sets in front of one panel, for tests of regions and of the states made from them.
#pragma once

#include "core/cameras/camera_set.h"

inline constexpr std::array<double, 2> panel{0.5, 0.3};

inline hogelscope::CameraSet boxSet(hogelscope::CameraSpread distribution, int count) {
  hogelscope::CameraSet set;
  set.params.count = count;
  set.region.distribution = distribution;
  set.region.region = hogelscope::RegionShape::box;
  set.region.centre = {0.1, -0.2, 0.7};
  set.region.extent = {0.6, 0.2, 0.4};
  return set;
}

inline hogelscope::CameraSet arcSet(hogelscope::CameraSpread distribution, int count) {
  hogelscope::CameraSet set = boxSet(distribution, count);
  set.region.region = hogelscope::RegionShape::arc;
  set.region.angle = {-40, 20};
  set.region.elevation = {5, 15};
  set.region.distance = {0.4, 0.9};
  return set;
}

inline bool near(const hogelscope::Vec3& a, const hogelscope::Vec3& b, double tolerance) {
  return length(a - b) <= tolerance;
}
