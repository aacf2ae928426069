// SPDX-License-Identifier: BSD-3-Clause
// Where a state's image is seen from. Metrics that model the eye need it.
#pragma once

#include <limits>

#include "core/optics/sampling.h"
#include "core/optics/session.h"

namespace hogelscope {

/// A figure that is not known is NaN.
struct Viewing {
  /// Pixels per degree of the eye's field, in the middle of the image: of both axes the geometric
  /// mean. NaN where the lens sends no light there.
  double pixelsPerDegree = std::numeric_limits<double>::quiet_NaN();
  double distance = std::numeric_limits<double>::quiet_NaN();  ///< eye to panel's centre, metres
};

/// Returns it for one state (docs/formulas.md, Metrics). Throws InputError if the state has
/// no camera frame.
Viewing viewingOf(const CameraState& state, const DisplayParams& display, LensMapping mapping);

}  // namespace hogelscope
