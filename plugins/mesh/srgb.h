// SPDX-License-Identifier: BSD-3-Clause
// sRGB code values and linear light (IEC 61966-2-1).
#pragma once

#include <array>

namespace hogelscope::mesh {

/// Red, green, blue in linear light: 1 is white.
using Linear = std::array<float, 3>;

/// Returns the linear light of an encoded value, 0 … 1.
double linearOf(double encoded);

/// Returns the code value, 0 … 255, of linear light, clipped to 0 … 1. Uses a table, within 0.005
/// of the formula.
float codeOf(float linear);

}  // namespace hogelscope::mesh
