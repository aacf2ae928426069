// SPDX-License-Identifier: BSD-3-Clause
// Camera calibrations as OpenCV writes them (cv::FileStorage, YAML or JSON).
#pragma once

#include <filesystem>
#include <optional>

#include "core/optics/session.h"

namespace hogelscope {

/// The parameters that a calibrated camera gives to a state.
struct Calibration {
  IntrinsicsParams intrinsics;
  DistortionParams distortion;
  std::optional<std::array<int, 2>> res;  ///< if the file gives the image size
};

/// Reads `camera_matrix` and `distortion_coefficients` (also K and D, M1 and D1, cameraMatrix and
/// distCoeffs) with four or five coefficients, and `image_width`, `image_height`. Throws InputError
/// (missing file, wrong kind, skew, more coefficients, values out of range).
Calibration loadCalibration(const std::filesystem::path& file);

struct NamedCalibration {
  std::string name;
  Calibration calibration;
};

/// Reads several cameras from a JSON list,
/// {"cameras": [{"name": …, "size": [w, h], "K": [fx, fy, cx, cy], "D": [k1, k2, p1, p2, k3]}]},
/// k3 may be left out, other keys are ignored. Also reads a file for loadCalibration(): the camera
/// is named after the file, and the image is centred on the principal point if its size is not
/// given. Throws InputError as loadCalibration() does, also for two cameras of one name.
std::vector<NamedCalibration> loadCalibrations(const std::filesystem::path& file);

/// Gives a state the intrinsics, the distortion and, if known, the resolution of a calibrated
/// camera.
void apply(const Calibration& calibration, CameraState& state);

}  // namespace hogelscope
