// SPDX-License-Identifier: BSD-3-Clause
// What stands behind a traced pixel: why it is black, what its light is made of, and its hogel.
#pragma once

#include <vector>

#include "core/optics/image.h"
#include "core/optics/pixel_trace.h"

namespace hogelscope {

/// What a pixel shows; the first three are black.
enum class PixelFate {
  noRay,    ///< no ray passes the lens to this pixel
  outside,  ///< its ray leaves the panel's light out: beside it, behind it, or outside its zone
  dark,     ///< it sees the display, whose content is black there
  lit
};

/// By all of the pixel's rays: where one of them sees the display, the pixel does. Dark is what is
/// rounded to 0 in 8 bits.
PixelFate fateOf(const PixelTrace& trace);

/// Returns the share of the light that direction (u + x, v + y) of a hogel adds to what is seen of
/// direction (u, v): windowSize² weights, row by row from x = y = -n, 0 outside the hogel. They add
/// up to 1, with the border `black` to less. `params.sigma` must be above 0 if windowSize > 1.
std::vector<double> psfKernelAt(const PsfParams& params, const LightFieldSize& size, int u, int v);

/// Returns the image of hogel (i, j), one pixel for each direction. Of a light field that is not in
/// memory it is of the overview's hogel and directions, since to fetch all directions of one hogel
/// may take long. Throws InputError.
Image hogelImage(const LightFieldSource& lightField, int i, int j);

}  // namespace hogelscope
