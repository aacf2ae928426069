// SPDX-License-Identifier: BSD-3-Clause
// Layout "views" in one file: the frames of a video, or a data set of HDF5.
#pragma once

#include <memory>
#include <string>

#include "core/optics/display.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Whether a file is a video by its name, or HDF5 by its first bytes.
bool isViewSequence(const std::string& file);

/// Opens the views of a video, which count row by row (LightFieldParams::scan), or of the data set
/// of HDF5 (openHdf5). Throws InputError that names the file.
std::unique_ptr<LightFieldFile> openViewSequence(const LightFieldParams& params,
                                                 const DisplayParams& display);

}  // namespace hogelscope
