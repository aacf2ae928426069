// SPDX-License-Identifier: BSD-3-Clause
// Finds the cameras of a folder's views in a file beside them, and how to read the views' names so
// that they stand as their cameras did.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "capture/order/camera_grid.h"
#include "io/cameras/camera_file.h"
#include "io/opening/light_field_order.h"

namespace hogelscope {

/// The cameras of views in a grid, and the parameters that read the views in its order.
struct ViewCameras {
  CameraGrid grid;
  std::vector<FileCamera> cameras;  ///< those that `grid.cameras` count
  bool hasScale = false;            ///< as CameraFile's
  CameraOrder order;
  std::string pattern;
  ViewScan scan = ViewScan::raster;
  bool isCounted = false;  ///< the views have running numbers, which need the grid's size
};

/// The order of views by a file of cameras that lies beside them.
struct ViewCamerasSearch {
  std::optional<ViewCameras> found;
  std::vector<std::string> lines;  ///< why a file is not used, or what it contradicts
  /// The cameras stand in a grid, along which the names do not run.
  bool isContradicted = false;
};

/// Searches beside the views, and in the folder above one whose name begins with "images", for
/// transforms.json, and for COLMAP's cameras and images, also in sparse/0. Parameters that are
/// given stay: a pattern, directions, and the scan if `isScanGiven`. Never throws InputError for a
/// file of cameras: a line says what is wrong with it.
ViewCamerasSearch findViewCameras(const LightFieldParams& params, const DisplayParams& display,
                                  bool isScanGiven);

}  // namespace hogelscope
