// SPDX-License-Identifier: BSD-3-Clause
// Camera calibrations as OpenCV writes them (cv::FileStorage, YAML or JSON).
#pragma once

#include <filesystem>
#include <optional>

#include "core/optics/session.h"

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

struct NamedCalibration {
  std::string name;
  Calibration calibration;
};

/// Several cameras: a JSON list,
/// {"cameras": [{"name": …, "size": [w, h], "K": [fx, fy, cx, cy], "D": [k1, k2, p1, p2, k3]}]},
/// k3 may be left out, other keys are somebody's notes; or what loadCalibration reads, named after
/// the file, whose picture is centred on the principal point where its size is not said. Throws
/// InputError, as loadCalibration does; also for two cameras of one name.
std::vector<NamedCalibration> loadCalibrations(const std::filesystem::path& file);

/// The state then takes the pictures of the calibrated camera: its lens, its intrinsics, and its
/// resolution where that is known.
void apply(const Calibration& calibration, CameraState& state);

}  // namespace hogelscope
