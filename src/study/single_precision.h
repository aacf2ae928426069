// SPDX-License-Identifier: BSD-3-Clause
// The reference engine's geometry in float or double, to measure the error of floats.
#pragma once

#include "core/optics/simulate.h"

namespace hogelscope {

/// Renders with all geometry of docs/formulas.md in `Real`, float or double, starting from world
/// coordinates: nearest, one ray per pixel, no leakage, no lens distortion, an unrotated panel.
template <class Real>
Image pictureIn(const RenderJob& job);

extern template Image pictureIn<float>(const RenderJob& job);
extern template Image pictureIn<double>(const RenderJob& job);

}  // namespace hogelscope
