// SPDX-License-Identifier: BSD-3-Clause
// The trace of one pixel: its ray, the hogel and direction that it meets, its colour, why it is
// black, and the parts of its light.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/optics/image.h"
#include "core/optics/simulate.h"

namespace hogelscope {

/// The outcome of a pixel's ray.
enum class RayEnd {
  noRay,         ///< the lens folds or ends nearer to the centre than this pixel
  misses,        ///< it does not meet the panel's front
  outsideField,  ///< it meets the panel outside the hogel's angular field
  seen
};

std::string_view words(RayEnd end);

/// Returns the end of a ray that Display::intersectPlane() has intersected.
RayEnd endOf(const Display& display, const std::optional<Hit>& place);

/// The ray through the middle of a pixel. Lengths are in metres.
struct PixelTrace {
  RayEnd end = RayEnd::noRay;
  Vec3 eye;       ///< the pinhole in the world frame
  Vec3 target;    ///< the ray's end in the world frame: on the panel's plane, or as far as lookat
  Vec2 position;  ///< the target in the display frame; valid if `place` has a value
  Vec2 slopes;    ///< dx/dz, dy/dz of the light in the display frame; valid as `position` is
  std::optional<Hit> place;  ///< hogel and direction, also beyond the panel and the angular field
  /// Directional pixels that add up to the light of the nearest direction; 0: not seen, or on a
  /// lens sheet.
  int taps = 0;
  std::optional<Rgb> colour;  ///< the colour of all rays, code values; none: not seen
};

/// Traces a pixel by the reference engine. `x` and `y` count from the image's upper left. Throws
/// InputError as Simulation does.
PixelTrace pixelTrace(const RenderJob& job, int x, int y);

/// The content of a pixel; the first three are black.
enum class PixelFate {
  noRay,    ///< no ray passes the lens to this pixel
  outside,  ///< its ray meets no light: it is beside or behind the panel, or outside its zone
  dark,     ///< it sees the display, whose content is black there
  lit
};

/// Returns the fate by all of the pixel's rays: if one of them sees the display, the pixel does.
/// Light that is rounded to 0 in 8 bits is dark.
PixelFate fateOf(const PixelTrace& trace);

/// Returns the share of the light that direction (u + x, v + y) of a hogel adds to the light seen
/// in direction (u, v): windowSize² weights, row by row from x = y = -n, 0 outside the hogel. Their
/// sum is 1, or less with the border `black`. `params.sigma` must be above 0 if windowSize > 1.
std::vector<double> psfKernelAt(const PsfParams& params, const LightFieldSize& size, int u, int v);

/// Returns the image of hogel (i, j), one pixel for each direction. For a light field that is not
/// in memory it shows the overview's hogel and directions, since fetching all directions of one
/// hogel may take long. Throws InputError.
Image hogelImage(const LightFieldSource& lightField, int i, int j);

}  // namespace hogelscope
