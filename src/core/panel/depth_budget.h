// SPDX-License-Identifier: BSD-3-Clause
// Whether content fits a display in depth (docs/formulas.md, Depth budget). Depths are compared in
// dioptres of an eye at the distance D from the panel's plane, as dioptresAt() gives them: 0 on the
// panel, + in front of it. A limit there is the same number in front and behind.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "core/panel/display.h"

namespace hogelscope {

/// The session's `depth`, for --depth.
struct DepthParams {
  double share = 0.95;   ///< the part of the pixels that should lie within the limits
  double comfort = 1;    ///< the largest disparity between the eyes that is comfortable, degrees
  double ipd = 0.063;    ///< metres, of states without two eyes
  double pupil = 0.004;  ///< metres, of states without a pupil
  bool operator==(const DepthParams&) const = default;
};

void describe(ParameterVisitor& v, DepthParams& p);

/// The inverse of dioptresAt(): the depth z in metres; −∞ for −1/distance and below.
double depthAt(double dioptres, double distance);

/// A depth in front of the panel and one behind it, both ≥ 0 and in metres; infinite if there is no
/// limit behind.
struct DepthRange {
  double front = 0;
  double behind = 0;
};

enum class DepthLimit { display, comfort, both };

/// What an eye at `distance` can be shown, in dioptres to either side of the panel; infinite if
/// nothing limits it.
struct DepthLimits {
  double distance = 0;
  double display = 0;             ///< p/(s D²): a direction is as wide as a hogel
  double comfort = 0;             ///< comfort angle / distance between the eyes
  double directionsPerPupil = 0;  ///< K = pupil/(D s); below 1 the eye cannot focus on content

  [[nodiscard]] double both() const { return display < comfort ? display : comfort; }
  /// Returns these with one limit alone; "both" are as they are.
  [[nodiscard]] DepthLimits only(DepthLimit which) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    DepthLimits result = *this;
    if (which == DepthLimit::display) result.comfort = none;
    if (which == DepthLimit::comfort) result.display = none;
    return result;
  }
  /// Whether content is within a limit. What was moved to lie on it is, in spite of rounding.
  [[nodiscard]] static bool isWithin(double dioptres, double limit) {
    constexpr double rounding = 1e-5;
    return dioptres <= limit * (1 + rounding) && dioptres >= -limit * (1 + rounding);
  }
  /// Returns a limit as depths.
  [[nodiscard]] DepthRange inMetres(double limit) const;
  /// Returns how far a point shifts on the panel, as the eye sees it, from one direction to the
  /// next, in hogels: −s D² Δ/p, so |shift| ≤ 1 exactly within the display's limit. Negative in
  /// front. Of the axis that shifts more.
  [[nodiscard]] double disparityOf(double dioptres) const;
  /// Returns |Δ| if the eye stays focused on the panel, else 0: what convergence and focus differ
  /// by, in dioptres.
  [[nodiscard]] double mismatchOf(double dioptres) const;
};

/// `display` must have its hogels and directions, `distance` > 0. Throws InputError as lensOf().
DepthLimits depthLimits(const PanelParams& display, double distance, const DepthParams& params);

/// Returns the shortest interval that holds at least `share` of the values, from one of them to
/// another. `sorted` ascends and is not empty.
std::array<double, 2> shortestInterval(std::span<const double> sorted, double share);

/// The map x → scale·(x − zero), which brings an interval within limits.
struct DepthFit {
  double scale = 1;  ///< ≤ 1
  double zero = 0;
};

/// Returns the map that brings [back, front] within −behind … before, in dioptres or in metres: the
/// smallest shift if that is enough, else the largest scale. `behind` may be infinite.
DepthFit fitDepths(double back, double front, double behind, double before);

}  // namespace hogelscope
