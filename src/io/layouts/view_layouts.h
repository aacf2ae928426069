// SPDX-License-Identifier: BSD-3-Clause
// Layouts "views" and "quilt": pictures of the same direction of all hogels.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "core/optics/display.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// A folder or %-pattern of pictures. Throws InputError that names the file or the folder.
std::unique_ptr<LightFieldFile> openViews(const LightFieldParams& params,
                                          const DisplayParams& display);

/// One picture of a row of views. Throws InputError that names it.
std::unique_ptr<LightFieldFile> openQuilt(const LightFieldParams& params);

/// Columns and rows that a quilt's name says (…_qs8x6a0.75.png); 0 where it does not.
std::array<int, 2> quiltTilesFromName(const std::string& file);

}  // namespace hogelscope
