// SPDX-License-Identifier: BSD-3-Clause
// The calibration of a lens sheet, as Looking Glass units have it (visual.json).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/panel/lens_sheet.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

/// Whether a file is a JSON object with most of a calibration's keys.
bool isSheetCalibration(const std::filesystem::path& file);

/// Reads pitch, slope, center, viewCone, DPI, screenW, screenH, each as a number or {"value": …},
/// and, if it has them, serial, CellPatternMode and subpixelCells; other keys are allowed. Adds
/// what the program ignores to `warnings`. Throws InputError, also for mirrored panels
/// (flipImageX).
SheetCalibration loadSheetCalibration(const std::filesystem::path& file,
                                      std::vector<std::string>* warnings = nullptr);

/// Returns what the file says in the form of a session's `calibration`. Throws likewise.
Json sheetObject(const std::filesystem::path& file);

}  // namespace hogelscope
