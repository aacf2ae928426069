// SPDX-License-Identifier: BSD-3-Clause
// What captures say of their cameras in a file of their own, beside the views.
#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "capture/names/view_grid.h"

namespace hogelscope {

/// A grid of cameras that look straight ahead; (across, down).
struct CaptureGeometry {
  std::array<double, 2> panel{};    ///< what a camera sees of the plane in focus, metres
  std::array<double, 2> spacing{};  ///< of neighbouring cameras, metres
  double distance = 0;              ///< from the cameras to the plane in focus, metres
  bool isShifted = false;           ///< the views coincide on that plane already

  /// Returns the full angles, in degrees, into which the panel's centre sees so many cameras, with
  /// half their spacing beyond the outer ones: `display.fov`.
  [[nodiscard]] std::array<double, 2> fovOf(int columns, int rows) const;
  /// Returns the shear that makes views of so many pixels coincide on the plane in focus.
  [[nodiscard]] std::array<double, 2> shearOf(int width, int height) const;
};

/// Reads `parameters.cfg` of the HCI 4D light field benchmark (baseline_mm, focus_distance_m,
/// focal_length_mm, sensor_size_mm), or `config.cfg` of light-field-renderer (focus-distance, in
/// metres) with the positions, focal length and sensor width in its file names ("…_-Y_X_F_S.jpg",
/// in millimetres). Views have width × height pixels. None if the folder has neither, or not all of
/// this. Throws InputError: a number is not one, or out of range.
std::optional<CaptureGeometry> captureGeometry(const std::filesystem::path& folder,
                                               const ViewFiles& views, int width, int height);

}  // namespace hogelscope
