// SPDX-License-Identifier: BSD-3-Clause
// The trace of one pixel: its ray, the hogel and direction that it meets, its colour.
#pragma once

#include <optional>
#include <string_view>

#include "core/optics/simulate.h"

namespace hogelscope {

/// The outcome of a pixel's ray.
enum class RayEnd {
  noRay,         ///< the lens folds nearer to the centre than this pixel
  misses,        ///< it does not meet the panel's front
  outsideField,  ///< it meets the panel outside the hogel's angular field
  seen
};

std::string_view words(RayEnd end);

/// The ray through the middle of a pixel. Lengths are in metres.
struct PixelTrace {
  RayEnd end = RayEnd::noRay;
  Vec3 eye;       ///< the pinhole in the world frame
  Vec3 target;    ///< the ray's end in the world frame: on the panel's plane, or as far as lookat
  Vec2 position;  ///< the target in the display frame; valid if `place` has a value
  Vec2 slopes;    ///< dx/dz, dy/dz of the light in the display frame; valid as `position` is
  std::optional<Hit> place;  ///< hogel and direction, also beyond the panel and the angular field
  int taps =
      0;  ///< directional pixels that add up to the light of the nearest direction; 0: not seen
  std::optional<Rgb> colour;  ///< the colour of all rays, code values; none: not seen
};

/// Traces a pixel by the reference engine. `x` and `y` count from the image's upper left. Throws
/// InputError as Simulation does.
PixelTrace pixelTrace(const RenderJob& job, int x, int y);

}  // namespace hogelscope
