// SPDX-License-Identifier: BSD-3-Clause
// Writes a light field of any layout as one image of hogels, a folder of views, a quilt or a
// mosaic, in bounded memory. Stores are written by io/store/store_writer.h. Values keep their type.
#pragma once

#include <array>
#include <filesystem>

#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Writes the image of hogels. Throws InputError, also if the image's format does not hold the
/// type, or Cancelled, as the other functions do.
void exportHogels(LightFieldFile& lightField, const std::filesystem::path& file,
                  const Progress& progress);

/// Writes FOLDER/RRR_CCC.png, floats as .exr, which openLightField() reads without further
/// parameters: row 000 was taken from the top, column 000 from the left. The folder must have no
/// other files. A light field larger than memory must be live or a store.
void exportViews(LightFieldFile& lightField, const std::filesystem::path& folder,
                 const Progress& progress);

/// Returns the tiles, across and down, that the name gives ("_qs8x6a0.75"), or those of an almost
/// square image. Throws InputError if the name has another number than that of the directions, or
/// if there is more than one row of directions.
std::array<int, 2> quiltTilesFor(const LightFieldFile& lightField,
                                 const std::filesystem::path& file);

/// Writes a quilt: view 0 is its bottom left tile and was taken from the left.
void exportQuilt(LightFieldFile& lightField, const std::filesystem::path& file,
                 const Progress& progress);

/// Writes a mosaic of views: the first row of its tiles was taken from the top, the first column
/// from the left.
void exportMosaic(LightFieldFile& lightField, const std::filesystem::path& file,
                  const Progress& progress);

}  // namespace hogelscope
