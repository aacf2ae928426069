// SPDX-License-Identifier: BSD-3-Clause
// The viewer's pupil: a thin lens that focuses on a plane, its opening sampled by points
// (docs/formulas.md, Pupil and focus).
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parameters.h"
#include "core/optics/camera.h"
#include "core/panel/display.h"

namespace hogelscope {

/// A state's `pupil`; lengths are in metres.
struct PupilParams {
  double diameter = 0;  ///< 0: a pinhole
  double focus = 0;     ///< along the camera's axis; 0: on the panel
  int samples = 0;      ///< points of the aperture; 0: as many as the display needs
  bool operator==(const PupilParams&) const = default;
};

void describe(ParameterVisitor& v, PupilParams& p);

/// The arrangement of the points in the aperture.
enum class AperturePattern {
  vogel,  ///< on a Vogel spiral (H. Vogel, Mathematical Biosciences 44, 1979)
  grid,   ///< the middles of a square grid's cells that lie in the disc
  random  ///< independent, uniform over the disc, the same every time
};

/// Returns the pattern's name.
std::string_view nameOf(AperturePattern pattern);

/// Returns points of a disc around (0, 0), to the right and down, in the diameter's unit. A grid
/// has at least `count` points, of the coarsest one that has so many; other patterns have `count`.
std::vector<Vec2> discPoints(AperturePattern pattern, double diameter, int count);

/// A point of the aperture, from which one image is taken.
struct AperturePoint {
  Vec2 offset;  ///< from the eye, to the right and down, metres
  Vec2 shift;   ///< what is added to each ideal point (x, y) of the plane z = 1
};

struct Aperture {
  std::vector<AperturePoint> points{{}};  ///< equal in weight; one, in the eye, for a pinhole
  bool isPinhole = true;                  ///< one image from the eye is the view
  double focus = 0;                       ///< metres along the axis; 0 if there is no pupil
  double directions = 0;                  ///< directions that enter the pupil from one hogel
  double hogels = 0;                      ///< hogels that one point of the image is spread over
  int wanted = 0;  ///< points that the display needs, which may be more than mostSamples
  static constexpr int mostSamples = 4096;
  /// The sum of directions and hogels below which an automatic count takes a pinhole.
  static constexpr double negligible = 0.1;
};

/// Says what is wrong with a focus on a panel whose plane the camera's axis does not meet.
constexpr auto* noFocusOnPanel =
    "is 0, on the panel, whose plane the camera's axis does not meet: give a distance in metres";

/// Returns the aperture of a camera that looks at a display, which must have its hogels and
/// directions if the number of samples is automatic. Throws InputError if the focus is to be on the
/// panel and the axis does not meet the panel's plane, and as Camera does.
Aperture apertureOf(const PupilParams& pupil, const CameraParams& camera,
                    const PanelParams& display, AperturePattern pattern = AperturePattern::vogel);

/// Returns the way along a camera's axis to the panel's plane, metres; 0 if it does not meet it.
double axisDistance(const CameraParams& camera, const DisplayParams& display);

/// Returns the camera frame of an image taken from a point of the aperture.
inline RigidTransform fromPoint(const RigidTransform& camera, const AperturePoint& point) {
  RigidTransform moved = camera;
  moved.origin = camera.point({point.offset.x, point.offset.y, 0});
  moved.zAxis = camera.direction({point.shift.x, point.shift.y, 1});
  return moved;
}

}  // namespace hogelscope
