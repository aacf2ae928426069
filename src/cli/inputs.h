// SPDX-License-Identifier: BSD-3-Clause
// The sessions and light fields that the jobs of the command line begin with.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "core/base/shard.h"
#include "core/optics/session.h"
#include "io/layouts/light_field_file.h"
#include "io/opening/session_around.h"

namespace hogelscope {

/// The session that --session names, or a new one around a folder, a picture or a mesh, with --set,
/// and with --calibration if the job has it. What its pictures say against the order of its views
/// goes to stderr. Throws InputError, or Cancelled.
Session loadSessionOf(const CommandLine& line);

/// Writes the session to --save-session, if that is given. Throws InputError.
void keepSession(const CommandLine& line, const Session& session);

/// The same session with only the states that --states selects; its other warnings go to stderr,
/// too. Throws InputError, or Cancelled.
Session loadSelected(const CommandLine& line);

/// What --shard says; none without it. Throws InputError.
std::optional<Shard> shardOf(const CommandLine& line);

/// The files of a session's light field and lens, after the other ones that a job reads.
std::vector<std::filesystem::path> inputFiles(std::vector<std::filesystem::path> others,
                                              const Session& session,
                                              const LightFieldFile& lightField);

/// Prints what a light field lacks on stderr, unless the job is quiet.
void warnOf(const LightFieldFile& lightField, const std::string& name, const CommandLine& line);

/// Prints what of a mesh that was given in place of a session the panel cuts, as the first state
/// sees it, unless the job is quiet. Authors of sessions know.
void warnOfCuts(const LightFieldFile& lightField, const Session& session, const CommandLine& line);

/// A new session around the light field that the job's own option names, read as --set says. Throws
/// InputError, also for a --set of what such a session does not have: camera states and their
/// sampling.
OrderedSession sessionAroundSubject(const CommandLine& line);

/// ", about 4 min" for reading a plain PNG, or another file of so many pixels, on one core; "" for
/// some seconds.
std::string readingTimeText(const LightFieldFile& file);

/// Prints before the wait, unless `isQuiet`, that a light field is too large for `memory` and will
/// be read from the top, and about how long that takes.
void announceStreaming(const LightFieldFile& file, std::size_t memory, bool isQuiet);

}  // namespace hogelscope
