// SPDX-License-Identifier: BSD-3-Clause
// How many views a picture of tiles has, by how alike they are.
#pragma once

#include <array>
#include <optional>

#include "io/images/image_file.h"

namespace hogelscope {

/// Reads the picture: views of one scene lie where it is much more like itself one tile further
/// than a bit less or more. Returns the tiles across and down, at most 20 of at least 100 pixels
/// each; none where no such grid stands out along both axes, or beyond 300 million pixels. Throws
/// InputError, Cancelled.
std::optional<std::array<int, 2>> findTileGrid(ImageFile& image, const Progress& progress);

}  // namespace hogelscope
