// SPDX-License-Identifier: BSD-3-Clause
// The files of a twin's maps: pictures whose channels are measured values, and tables of
// directions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/panel/twin.h"

namespace hogelscope {

/// Reads the maps of a twin for a design with its hogels and directions. Row 0 is the top; what has
/// no file, and the channels that a file does not have, stay empty: as designed.
///
/// `hogels` has at most as many pixels as the display has hogels, across and down, and channels of
/// floats: shift.x, shift.y (metres, right and up), tilt.x, tilt.y (slopes), gap (parts of the
/// gap), gain.R, gain.G, gain.B (at least 0).
///
/// `directions` has at most as many pixels as a hogel has directions, and the channels move.u,
/// move.v (px), sigma (px, above 0), gain.R, gain.G, gain.B. Named .csv it is a table instead
/// (parseMeasuredDirections), from whose slopes the moves are worked out (docs/formulas.md, Twin).
/// Directions that it does not have are fitted, which adds a line to `warnings`.
///
/// `height` has at most 16384 pixels across and down, over the whole panel, and the channel height
/// or only one channel: metres toward the viewer.
///
/// `kernels` is an image of any format, of which only the proportions within a kernel count.
///
/// Throws InputError that names the file, and the channel and pixel or the line; Cancelled.
TwinMaps readTwinMaps(const TwinMapFiles& files, const PanelParams& design,
                      const Progress& progress = {}, std::vector<std::string>* warnings = nullptr);

/// Writes the maps of the hogels, at least one of which is not empty, as an EXR with the channels
/// of readTwinMaps(). It is as large as the largest of them; others are interpolated
/// (TwinPlane::atCell), so that the same twin is read from it if that has the size of the hogels.
/// Throws InputError that names the file.
void writeHogelMaps(const std::filesystem::path& file, const TwinMaps& maps);

}  // namespace hogelscope
