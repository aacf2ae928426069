// SPDX-License-Identifier: BSD-3-Clause
// The display's viewing zone: the points that its light reaches.
#pragma once

#include <array>
#include <vector>

#include "core/panel/display.h"

namespace hogelscope {

/// Returns the share of the panel's area, 0 … 1, that sends light to a point of the world (metres):
/// 1 if all of the panel can be seen from there, 0 if the point is outside the viewing zone. A lens
/// sheet sends light to all places before it.
double shareSeenFrom(const PanelParams& display, const Vec3& point);

/// The points reached by light of some part of the panel, or by light of every part.
enum class ViewingZone { someOfThePanel, wholePanel };

/// A rectangle parallel to the panel, in the display frame, metres; x and y.
struct ZoneSection {
  double z = 0;
  std::array<double, 2> low{};
  std::array<double, 2> high{};
};

/// Returns sections of a viewing zone, from its point nearest to the panel to `farthest` metres in
/// front of it, if it reaches so far; its sides are plane between two sections. Empty if there is
/// no zone.
std::vector<ZoneSection> sectionsOf(const PanelParams& display, ViewingZone zone, double farthest);

/// Returns the corners of a viewing zone's section as far in front of the panel as a point of the
/// world: in the world, in order around it. Empty if the zone does not reach there.
std::vector<Vec3> zoneAt(const PanelParams& display, ViewingZone zone, const Vec3& point);

/// Returns a section's corners in the world, in order around it.
std::vector<Vec3> cornersOf(const PanelParams& display, const ZoneSection& section);

}  // namespace hogelscope
