// SPDX-License-Identifier: BSD-3-Clause
// Camera calibrations as OpenCV writes them (cv::FileStorage, YAML or JSON).
#pragma once

#include <filesystem>
#include <optional>

#include "core/session.h"

namespace hogelscope {

/// What a calibrated camera gives to a state.
struct Calibration {
  IntrinsicsParams intrinsics;
  DistortionParams distortion;
  std::optional<std::array<int, 2>> res;  ///< where the file says its pictures' size
};

/// Reads `camera_matrix` and `distortion_coefficients` (also K and D, M1 and D1, cameraMatrix and
/// distCoeffs) with four or five coefficients, and `image_width`, `image_height`. Throws
/// InputError: no such file, not of that kind, skew, more coefficients, values out of our ranges.
Calibration loadCalibration(const std::filesystem::path& file);

/// The state then takes the pictures of the calibrated camera: its lens, its intrinsics, and its
/// resolution where that is known.
void apply(const Calibration& calibration, CameraState& state);

}  // namespace hogelscope
