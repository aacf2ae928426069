// SPDX-License-Identifier: BSD-3-Clause
// What the jobs of the command line begin with.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/options.h"
#include "core/optics/session.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// The session with --calibration, --set and only the --states asked for; warnings go to stderr.
/// Throws InputError.
Session loadSelected(const Options& options);

/// Every file that the command line names to be read, and those of a light field.
std::vector<std::filesystem::path> inputsOf(const Options& options,
                                            const LightFieldFile* lightField = nullptr);

/// A new session around a light field, read as --set says. Throws InputError, also for a --set of
/// what such a session does not have: camera states and their sampling.
Session aroundLightField(const std::string& file, const Options& options);

/// ", about 4 min" for reading a plain PNG, or another file of so many pixels, on one core; "" for
/// some seconds.
std::string readingTime(const LightFieldFile& file);

/// Tells before the wait, unless --quiet, where a light field is too large for `memory` and will be
/// read from the top, and about how long that takes.
void announcePassing(const LightFieldFile& file, std::size_t memory, const Options& options);

}  // namespace hogelscope
