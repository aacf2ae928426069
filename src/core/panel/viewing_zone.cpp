// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/viewing_zone.h"

#include <algorithm>
#include <limits>

namespace hogelscope {

namespace {

/// Returns the share of a side of the panel, centred on 0, whose light reaches a point at `at`, z
/// in front of it: the share of the positions x with (at - x)/z + convergence·x within the lens'
/// field.
double shareWithin(double side, double at, double z, double convergence, const HogelLens& lens) {
  const double low = at - z * lens.slopeOf(0.5);  // ≤ x·(1 - z·convergence) ≤ high
  const double high = at - z * lens.slopeOf(-0.5);
  const double scale = 1 - z * convergence;
  if (scale == 0) return low <= 0 && 0 <= high ? 1 : 0;
  const double from = std::max(std::min(low / scale, high / scale), -side / 2);
  const double to = std::min(std::max(low / scale, high / scale), side / 2);
  return std::max(0.0, to - from) / side;
}

double convergenceOf(const PanelParams& display) {
  return display.viewingDistance > 0 ? 1 / display.viewingDistance : 0;
}

/// One axis of the zone. A point at `at`, z gets the light of place x if at - x·(1 - z·convergence)
/// is within z·least … z·most.
struct ZoneSide {
  double side;
  double least;
  double most;
  double convergence;

  /// Returns how far the panel's edges move the limits apart, or together.
  [[nodiscard]] double reach(double z) const { return side / 2 * std::abs(1 - z * convergence); }
  /// Return the limits of z between which light of the whole panel meets: the width z·(most -
  /// least) - 2·reach(z) is not negative there.
  [[nodiscard]] double nearest() const { return side / (most - least + side * convergence); }
  [[nodiscard]] double farthest() const {
    const double narrowing = side * convergence - (most - least);
    return narrowing > 0 ? side / narrowing : std::numeric_limits<double>::infinity();
  }
};

ZoneSide sideOf(const PanelParams& display, std::size_t axis) {
  const auto lens = lensOf(display, int(axis));
  return {display.size[axis], lens->slopeOf(-0.5), lens->slopeOf(0.5), convergenceOf(display)};
}

}  // namespace

/// The two axes are independent.
double shareSeenFrom(const PanelParams& display, const Vec3& point) {
  const Vec3 p = transformFromPose(display.position, display.orientation).inverse().point(point);
  if (!(p.z > 0)) return 0;
  if (!hasDirections(display)) return 1;  // beside its cone the views are seen again
  const double convergence = convergenceOf(display);
  return shareWithin(display.size[0], p.x, p.z, convergence, *lensOf(display, 0)) *
         shareWithin(display.size[1], p.y, p.z, convergence, *lensOf(display, 1));
}

std::vector<ZoneSection> sectionsOf(const PanelParams& display, ViewingZone zone, double farthest) {
  const std::array sides{sideOf(display, 0), sideOf(display, 1)};
  const bool isWhole = zone == ViewingZone::wholePanel;
  double from = 0;
  double to = farthest;
  for (const ZoneSide& side : sides) {
    if (!std::isfinite(side.most - side.least)) return {};  // a field of 180°
    if (isWhole) from = std::max(from, side.nearest());
    if (isWhole) to = std::min(to, side.farthest());
  }
  if (!(from < to)) return {};
  std::vector<double> places{from, to};
  const double distance = display.viewingDistance;  // there the panel's edges change sides
  if (from < distance && distance < to) places.insert(places.begin() + 1, distance);
  std::vector<ZoneSection> sections;
  for (const double z : places) {
    ZoneSection& section = sections.emplace_back();
    section.z = z;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double reach = (isWhole ? -1 : 1) * sides[axis].reach(z);
      section.low[axis] = z * sides[axis].least - reach;
      section.high[axis] = z * sides[axis].most + reach;
    }
  }
  return sections;
}

std::vector<Vec3> zoneAt(const PanelParams& display, ViewingZone zone, const Vec3& point) {
  const double z =
      transformFromPose(display.position, display.orientation).inverse().point(point).z;
  const std::vector<ZoneSection> sections = sectionsOf(display, zone, z);
  if (sections.empty() || sections.back().z != z) return {};
  return cornersOf(display, sections.back());
}

std::vector<Vec3> cornersOf(const PanelParams& display, const ZoneSection& section) {
  const RigidTransform worldFromDisplay = transformFromPose(display.position, display.orientation);
  const auto& [z, low, high] = section;
  return {worldFromDisplay.point({low[0], low[1], z}), worldFromDisplay.point({high[0], low[1], z}),
          worldFromDisplay.point({high[0], high[1], z}),
          worldFromDisplay.point({low[0], high[1], z})};
}

}  // namespace hogelscope
