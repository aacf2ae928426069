// SPDX-License-Identifier: BSD-3-Clause
// One pixel's way along the line: its ray, the hogel and direction that it meets, its colour.
#pragma once

#include <optional>
#include <string_view>

#include "core/optics/simulate.h"

namespace hogelscope {

/// What becomes of a pixel's ray.
enum class RayEnd {
  noRay,         ///< the lens folds before this pixel
  misses,        ///< it does not meet the panel's front
  outsideField,  ///< it meets the panel where the hogel sends no light its way
  seen
};

std::string_view words(RayEnd end);

/// The ray through the middle of a pixel. Lengths in metres.
struct PixelTrace {
  RayEnd end = RayEnd::noRay;
  Vec3 eye;       ///< in the world, as the next
  Vec3 target;    ///< on the panel's plane; where the ray does not meet it, as far as lookat
  Vec2 position;  ///< the target in the display frame; only where there is a place
  Vec2 slopes;    ///< dx/dz, dy/dz of the light in the display frame; likewise
  std::optional<Hit> place;  ///< hogel and direction, also beyond the panel and the angular field
  int taps =
      0;  ///< directional pixels that add up to the light of the nearest direction; 0: not seen
  std::optional<Rgb> colour;  ///< of the pixel with all its rays, code values; none: not seen
};

/// By the reference engine. `x` and `y` count from the picture's upper left. Throws InputError as
/// Simulation does.
PixelTrace trace(const View& view, int x, int y);

}  // namespace hogelscope
