// SPDX-License-Identifier: BSD-3-Clause
// Writes a light field of any layout as one image of hogels, a folder of views, a quilt, a mosaic
// or a store, in bounded memory. Values keep their type.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/optics/session.h"
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

/// Returns the tiles, across and down, that the name gives ("_qs8x6a0.75"), or those of the quilt
/// that is exported, `own`, or those of an almost square image. Throws InputError if the name has
/// another number than that of the directions, or if there is more than one row of directions.
std::array<int, 2> quiltTilesFor(const LightFieldSize& size, const std::filesystem::path& file,
                                 const LightFieldParams& own = {});

/// Writes a quilt: view 0 is its bottom left tile and was taken from the left.
void exportQuilt(LightFieldFile& lightField, const std::filesystem::path& file,
                 const Progress& progress, const LightFieldParams& own = {});

/// Writes a mosaic of views: the first row of its tiles was taken from the top, the first column
/// from the left.
void exportMosaic(LightFieldFile& lightField, const std::filesystem::path& file,
                  const Progress& progress);

/// Says what a light field is written as. woven: the picture of a lens sheet's panel; pack: a
/// store (io/store).
enum class ExportLayout { hogels, views, quilt, mosaic, woven, pack };

/// Returns the layout of a name, such as "quilt"; none if there is no such name.
std::optional<ExportLayout> exportLayoutNamed(const std::string& name);

/// Returns the layouts that a display's light field can be written as.
std::vector<ExportLayout> exportLayoutsOf(const DisplayParams& display);

/// Returns the light field that is written: the session's, or of a lens sheet the views that it
/// shows, or with `isForTwin`, on a display of hogels, the one that the session's twin needs.
/// Throws InputError, also without a twin; Cancelled.
std::shared_ptr<LightFieldFile> contentToExport(const Session& session, ExportLayout layout,
                                                bool isForTwin, const Progress& progress = {});

/// Writes a session's content as the functions above, or as a store with the session's display.
/// `output` is a file, or for views a folder.
void exportAs(ExportLayout layout, const Session& session, LightFieldFile& content,
              const std::filesystem::path& output, const Progress& progress);

/// A picture of 8-bit RGB, row by row.
struct ExportedPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Returns what exportAs() writes for a layout of one picture, in memory. `output` is the name that
/// may give a quilt's tiles.
ExportedPicture exportedPicture(ExportLayout layout, const Session& session,
                                LightFieldFile& content, const std::filesystem::path& output,
                                const Progress& progress);

}  // namespace hogelscope
