// SPDX-License-Identifier: BSD-3-Clause
// Calibrated cameras, as files describe them: lens, picture, and the place where they stood.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/optics/session.h"

namespace hogelscope {

/// A calibrated camera gives these to a state.
struct Calibration {
  IntrinsicsParams intrinsics;  ///< px, pixel centres at integers
  DistortionParams distortion;
  std::optional<std::array<int, 2>> res;  ///< px; if the file gives the picture's size
  /// Full angles that the picture spans across and down, degrees, of a file that gives them instead
  /// of focal lengths; one of them is enough, then pixels are square.
  std::array<double, 2> fov{notGiven, notGiven};
};

/// Returns the calibration with a picture's size and focal lengths. Without a size of its own that
/// of `shown` is taken; if the principal point is not in that picture, one with this point in its
/// middle, within the sizes that states may have.
Calibration completed(Calibration calibration, const std::array<int, 2>& shown);

/// Returns the intrinsics for the same picture in `scale` times as many pixels across and down.
IntrinsicsParams scaled(IntrinsicsParams intrinsics, double scale);

/// Gives a state the intrinsics, the distortion and the size of a calibrated camera, completed()
/// for the state's own size.
void apply(const Calibration& calibration, CameraState& state);

/// A camera of a file.
struct CalibratedCamera {
  std::string name;
  Calibration calibration;
  /// Its pose in the world, or in a rig's frame, in metres; the axes are right, down and forward.
  std::optional<RigidTransform> pose{};
};

/// The cameras of one file.
struct CalibratedCameras {
  std::vector<CalibratedCamera> cameras;
  bool isRig = false;  ///< poses are in the frame of the camera that the rig's first one stands for
};

/// Returns states like `model` for the cameras: those of a rig stand about the model's own pose,
/// those without a pose at it. Without distortion, intrinsics and size of its own a camera has the
/// model's. `middle` is the panel's, in the world; a state looks at the point of its axis next to
/// it. Names are those of the cameras, as far as they are names of files, else or twice numbered;
/// they differ from those of `others`. Throws InputError.
std::vector<CameraState> statesOf(const CalibratedCameras& cameras, const CameraState& model,
                                  const Vec3& middle, const std::vector<CameraState>& others);

}  // namespace hogelscope
