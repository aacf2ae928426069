// SPDX-License-Identifier: BSD-3-Clause
// The viewing conditions of a state's image, for metrics that model the eye.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "core/optics/sampling.h"
#include "core/optics/session.h"

namespace hogelscope {

/// A figure that is not known is NaN.
struct Viewing {
  /// Pixels per degree of the eye's field, in the middle of the image: the geometric mean of both
  /// axes. NaN if the lens sends no light there.
  double pixelsPerDegree = std::numeric_limits<double>::quiet_NaN();
  double distance = std::numeric_limits<double>::quiet_NaN();  ///< eye to panel's centre, metres
  std::string state{};                                         ///< its name
  std::optional<int> frame{};                                  ///< of a light field in time
};

/// Returns the viewing conditions of one state (docs/formulas.md, Metrics). Throws InputError if
/// the state has no camera frame.
Viewing viewingOf(const CameraState& state, const DisplayParams& display, LensMapping mapping);

}  // namespace hogelscope
