// SPDX-License-Identifier: BSD-3-Clause
// Layouts "views", "quilt" and "mosaic": images of one direction of all hogels.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "core/panel/display.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Opens a folder or %-pattern of images. Throws InputError that names the file or the folder.
std::unique_ptr<LightFieldFile> openViews(const LightFieldParams& params,
                                          const DisplayParams& display);

/// Opens one image of a row of views, as tiles row by row from the bottom left. Throws InputError
/// that names it.
std::unique_ptr<LightFieldFile> openQuilt(const LightFieldParams& params);

/// Opens one image of a grid of views, as many tiles as the display has directions, in the order of
/// the parameters. Throws InputError that names it.
std::unique_ptr<LightFieldFile> openMosaic(const LightFieldParams& params,
                                           const DisplayParams& display);

/// Returns the columns and rows in a quilt's name (…_qs8x6a0.75.png); 0 if there are none.
std::array<int, 2> quiltTilesFromName(const std::string& file);

/// Returns the width of the display in heights in a quilt's name, 0.75 there; 0 if there is none.
double quiltAspectFromName(const std::string& file);

}  // namespace hogelscope
