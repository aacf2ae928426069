// SPDX-License-Identifier: BSD-3-Clause
// A first guess at the lenslets of a picture, from the peaks of its spectrum.
#pragma once

#include <optional>

#include "capture/lenslets/lenslet_search.h"

namespace hogelscope {

/// Returns the step of a row from the peaks of the spectrum of the picture's middle, good to some
/// hundredths of a pixel; a pitch or rotation that is given restricts where they are looked for.
/// None if there are none.
std::optional<PicturePoint> stepFromSpectrum(const LensletPlane& picture,
                                             const LensletParams& params);

}  // namespace hogelscope
