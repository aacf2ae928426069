// SPDX-License-Identifier: BSD-3-Clause
// Reads camera sets from documents (JSON) and viewers' traces (CSV).
#pragma once

#include <string>
#include <vector>

#include "core/cameras/camera_set.h"

namespace hogelscope {

/// Reads the camera set `what`: uniform, random or normal; FILE.json, a document
/// {"hogelscopeCameras": 1, "cameraSet": {…}, "cameraRegion": {…}} with at most one of
///   "mixture": [{"weight": 2, "cameraRegion": {…}}, …]  a part's defaults are those outside,
///   "poses": [{"eye": [x, y, z], "lookat": [x, y, z], "weight": 1}, …],
///   "path": [{"eye": …}, …],
///   "trace": {"file": "tracks.csv", "time": "Timestamp", "timeUnit": 0.001, …};
/// or another file, which is {"trace": {"file": FILE}}: readTrace(); a missing z is that of
/// cameraRegion.centre.
/// `overrides` are as for loadSession(), for cameraSet, cameraRegion and trace; those for the
/// region apply to every part of a mixture too. Throws InputError that names the file and the place
/// in it.
/// A file of cameras (io/cameras/camera_file.h) is a set of them, of `camera` alone if it is not
/// "".
CameraSet loadCameraSet(const std::string& what, const std::vector<std::string>& overrides = {},
                        const std::string& camera = "");

}  // namespace hogelscope
