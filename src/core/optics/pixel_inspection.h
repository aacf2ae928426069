// SPDX-License-Identifier: BSD-3-Clause
// The data behind a traced pixel: why it is black, the parts of its light, and its hogel.
#pragma once

#include <vector>

#include "core/optics/image.h"
#include "core/optics/pixel_trace.h"

namespace hogelscope {

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
