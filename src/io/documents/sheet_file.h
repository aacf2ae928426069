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

/// Puts the calibration that a section ("display", "lightField") names as a file into a session's
/// document. Returns the name, or "". Throws InputError.
std::string embedSheet(Json& session, const char* section, const std::filesystem::path& folder);

/// Completes the light field's calibration, if it has one, by the figures of the display's.
void completeWeave(Json& session);

}  // namespace hogelscope
