// SPDX-License-Identifier: BSD-3-Clause
#include "lighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hogelscope::mesh {

namespace {

/// Returns the share of a spot's light in a direction (KHR_lights_punctual, "Inner and Outer Cone
/// Angles").
double coneShare(const Light& light, double cosine) {
  const double width = std::max(0.001, light.cosInner - light.cosOuter);
  const double share = std::clamp((cosine - light.cosOuter) / width, 0.0, 1.0);
  return share * share;
}

/// Returns the attenuation within a lamp's range (KHR_lights_punctual, "Range Property").
double rangeShare(const Light& light, double distance) {
  if (light.range <= 0) return 1;
  const double part = distance / light.range;
  return std::clamp(1 - part * part * part * part, 0.0, 1.0);
}

}  // namespace

std::optional<Arriving> lightAt(const Light& light, const Vec3& point, double unit) {
  Arriving arriving;
  double share = 1 / std::numbers::pi;
  if (light.kind == Light::Kind::directional) {
    arriving.way = -1.0 * light.direction;
    arriving.isDirection = true;
  } else {
    arriving.way = light.position - point;
    const double length = hogelscope::length(arriving.way);
    if (!(length > 0)) return std::nullopt;
    const double distance = length / unit;
    share *= rangeShare(light, distance) / (distance * distance);
    if (light.kind == Light::Kind::spot)
      share *= coneShare(light, -dot(arriving.way, light.direction) / length);
  }
  if (!(share > 0)) return std::nullopt;
  for (std::size_t c = 0; c < 3; ++c)
    arriving.strength[c] = float(std::min(share * double(light.intensity[c]), 1e30));
  return arriving;
}

}  // namespace hogelscope::mesh
