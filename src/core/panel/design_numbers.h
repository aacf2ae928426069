// SPDX-License-Identifier: BSD-3-Clause
// Computes what a display can show to an eye from the display's parameters alone
// (docs/formulas.md, Design numbers).
//
// Sharp depths. A point at the depth z (+ in front of the panel) is shown along directions that are
// s apart in slope, s the slope step, so on its own plane the light of one direction is |z| s wide.
// The eye at the distance D sees a length there as wide as one of the panel that is D/(D − z) times
// as long. The point is sharp for this eye where that is at most one hogel:
//
//     |z| s D/(D − z) ≤ p      in front: z ≤ p D/(s D + p)      behind: −z ≤ p D/(s D − p)
//
// and all that is behind is sharp if s D ≤ p. In dioptres, Δ = 1/(D − z) − 1/D, both limits are
// p/(s D²).
#pragma once

#include <array>

#include "core/panel/display.h"

namespace hogelscope {

/// The diameter of the pupil of directionsPerPupil, metres.
constexpr double designPupil = 0.004;

/// Lengths in metres, ≥ 0; 0 if the eye is not in front of the panel.
struct SharpDepths {
  double distance = 0;     ///< D, of the eye from the panel's plane
  double depthFront = 0;   ///< what is nearer to the eye than this is not sharp
  double depthBehind = 0;  ///< likewise behind the panel; infinite if there is no limit
  bool operator==(const SharpDepths&) const = default;
};

/// Pairs are across and down the panel. Numbers that are not known are 0.
struct DesignNumbers : SharpDepths {
  std::array<double, 2> hogelPitch{};           ///< metres
  std::array<double, 2> slopeStep{};            ///< of a direction in the middle of the field
  std::array<double, 2> degreesPerDirection{};  ///< there
  double megapixels = 0;                        ///< directional pixels of all hogels, in millions
  std::array<double, 2> hogelArcmin{};          ///< a hogel's width, as the eye sees it
  std::array<double, 2> directionsPerPupil{};
};

/// `display` must have its hogels and directions; `eye` is in the world, in metres. The numbers
/// after `megapixels` are 0 if the eye is not in front of the panel. An axis with one direction has
/// no steps that could blur, so depths are those of the other one. Throws InputError as lensOf().
DesignNumbers designNumbers(const PanelParams& display, const Vec3& eye);

/// Returns how much nearer than the panel a depth is, in dioptres of an eye at `distance`: 0 on the
/// panel, −1/distance for what is infinitely far behind it. `z` < `distance`.
double dioptresAt(double z, double distance);

/// Resizes an edited display so that its hogels keep the pitch that they had before the edit, if
/// both are known.
void holdPitch(const DisplayParams& before, DisplayParams& after);

/// Changes the directions of an edited display, or its hogels if its directions were edited, so
/// that it keeps about as many pixels along each axis as it had. An axis of one direction keeps it.
void holdPixels(const DisplayParams& before, DisplayParams& after);

}  // namespace hogelscope
