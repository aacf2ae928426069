// SPDX-License-Identifier: BSD-3-Clause
// Reads the geometry of cameras from the file that some captures have beside their views
// (docs/formulas.md, Display; docs/formulas.md, Order of views).
#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "capture/names/view_grid.h"
#include "io/opening/view_cameras.h"

namespace hogelscope {

/// A grid of cameras that look straight ahead; pairs are (across, down).
struct CaptureGeometry {
  std::array<double, 2> panel{};    ///< the part of the plane in focus that a camera sees, metres
  std::array<double, 2> spacing{};  ///< of neighbouring cameras, metres
  double distance = 0;              ///< from the cameras to the plane in focus, metres
  std::array<double, 2> shear{};    ///< makes the views coincide on that plane, pixels per view

  /// Returns `display.fov`: the full angles, in degrees, that so many cameras cover as seen from
  /// the panel's centre, with half their spacing beyond the outer ones.
  [[nodiscard]] std::array<double, 2> fovOf(int columns, int rows) const;
};

/// Reads `parameters.cfg` of the HCI 4D light field benchmark (baseline_mm, focus_distance_m,
/// focal_length_mm, sensor_size_mm), or `config.cfg` of light-field-renderer (focus-distance, in
/// metres) with the positions, focal length and sensor width in its file names ("…_-Y_X_F_S.jpg",
/// in millimetres). Views have width × height pixels. None if the folder has neither file, or not
/// all of these values. Throws InputError if a value is not a number or out of range.
std::optional<CaptureGeometry> captureGeometry(const std::filesystem::path& folder,
                                               const ViewFiles& views, int width, int height);

/// The plane in focus as the program knows it; files of cameras do not say it.
struct KnownFocus {
  double distance = notGiven;                  ///< from the cameras, metres
  std::optional<std::array<double, 2>> shear;  ///< seen in the views, without a distance
};

/// Returns the geometry of cameras in a grid, whose unit is taken for the metre. None if the plane
/// in focus is not known, or does not fit the cameras; `why` then says so in a line.
std::optional<CaptureGeometry> captureGeometry(const ViewCameras& cameras, const KnownFocus& focus,
                                               int width, int height, std::string& why);

}  // namespace hogelscope
