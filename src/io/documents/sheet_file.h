// SPDX-License-Identifier: BSD-3-Clause
// The calibration of a lens sheet, as Looking Glass units have it (visual.json).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/optics/session.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

/// Whether a file is a JSON object with most of a calibration's keys, or has such objects in it, as
/// the answer of the vendor's service has.
bool isSheetCalibration(const std::filesystem::path& file);

/// Reads pitch, slope, center, viewCone, DPI, screenW, screenH, each as a number or {"value": …},
/// and, if it has them, serial, CellPatternMode, subpixelCells and flipSubp (red and blue
/// sub-pixels exchanged); other keys are allowed. Of several calibrations the first is read. Adds
/// what the program ignores to `warnings`: the other calibrations, keys that it does not use and
/// whose value is not 0, invView 0. Throws InputError, also for mirrored panels (flipImageX,
/// flipImageY).
SheetCalibration loadSheetCalibration(const std::filesystem::path& file,
                                      std::vector<std::string>* warnings = nullptr);

/// Returns what the file says in the form of a session's `calibration`. Throws likewise.
Json sheetObject(const std::filesystem::path& file);

/// Returns what the program ignores of the calibrations that a session has or names. Throws
/// InputError.
std::vector<std::string> sheetWarnings(const Session& session);

}  // namespace hogelscope
