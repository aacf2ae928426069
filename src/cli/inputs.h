// SPDX-License-Identifier: BSD-3-Clause
// Input sessions and light fields of the jobs, and what all jobs do with them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "core/base/shard.h"
#include "core/cameras/frame_states.h"
#include "core/optics/session.h"
#include "io/files/files_in_use.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"

namespace hogelscope {

/// The session that --session names, or a new one around a folder, a picture or a mesh, with --set,
/// and with --calibration if the job has it. Contradictions between its pictures and the order of
/// its views are printed to stderr. Throws InputError, or Cancelled.
Session loadSessionOf(const CommandLine& line);

/// A job's session and its light field; no result replaces one of their files while it lives.
struct Input {
  /// Opens the light field: before anything is written, so that an invalid file leaves no folder
  /// behind. Throws InputError.
  explicit Input(const Session& read)
      : Input(read, openLightField(read.lightField, read.display)) {}
  /// `opened` is the light field, or is made of it.
  Input(Session read, std::shared_ptr<LightFieldFile> opened)
      : session(std::move(read)), file(std::move(opened)), inUse(filesOf(session, *file)) {}

  /// Returns the session's display with its hogels and directions. Throws InputError.
  [[nodiscard]] PanelParams display() const { return resolved(displayOf(session), file->size()); }

  Session session;
  std::shared_ptr<LightFieldFile> file;
  FilesInUse inUse;
};

/// Returns the session with the twin of a document, and the job's --set of twin.* over it. Throws
/// InputError.
Session withTwin(const Session& session, const std::string& file, const CommandLine& line);

/// Returns the files that the command line itself names to be read, without a session that the job
/// may replace.
std::vector<std::filesystem::path> namedInputs(const CommandLine& line);

/// Throws InputError if a file that the job will write, or that of --save-session, is one that it
/// reads, if two of them are one file, or if the session cannot be saved. Call it after the inputs
/// are marked (FilesInUse), before any work.
void checkResults(const CommandLine& line, const Session& session,
                  std::vector<std::filesystem::path> files);

/// Ends a job: writes the session to --save-session if that is given, as the last file, so that a
/// job that fails leaves none. Returns whether the job prints its results. Throws InputError.
bool finish(const CommandLine& line, const Session& session);

/// Returns the same session with only the states that --states selects; prints all warnings on
/// stderr. Throws InputError, also for a lens sheet if what the job makes, `ofHogels`, needs a
/// display of hogels; Cancelled.
Session loadSelected(const CommandLine& line, const char* ofHogels = nullptr);

/// Returns the shard of --shard; none without it. Throws InputError.
std::optional<Shard> shardOf(const CommandLine& line);

/// Returns the frames of --frames. Without it, none where a job makes one thing of each frame.
/// Throws InputError, also if there is no frame to choose.
std::optional<FrameNumbers> framesOf(const CommandLine& line, const LightFieldFile& lightField);

/// Prints, unless the job is quiet, that only the first of several frames is used.
void warnOfFrames(const CommandLine& line, const FrameNumbers& listed);

/// Returns each state at its frame (statesAtFrames()), with --frames at each of these; without, at
/// the first one, and says so unless the job is quiet. Throws InputError.
std::vector<FrameState> statesInTime(const CommandLine& line, const Input& input);

/// A frame of a light field and the file or folder for it.
struct FrameOutput {
  int frame = 0;
  std::filesystem::path output;
};

/// Returns the frames of --frames, or all where --output has {T}, with their outputs; without
/// either the first one, and says so unless the job is quiet. Throws InputError, also if several
/// frames have one output.
std::vector<FrameOutput> outputsOfFrames(const CommandLine& line, const LightFieldFile& lightField);

/// Keeps the shard's share of states, or of a light field in time whole frames that follow each
/// other: each frame is read by one process.
void keepShard(std::vector<FrameState>& states, const Shard& shard);

/// Prints missing parts of a light field on stderr, unless the job is quiet.
void warnOf(const LightFieldFile& lightField, const std::string& name, const CommandLine& line);

/// Prints which part of a mesh given as --session is cut by the panel, as the first state sees it,
/// unless the job is quiet. For other sessions it prints nothing.
void warnOfCuts(const LightFieldFile& lightField, const Session& session, const CommandLine& line);

/// Prints, unless the job is quiet, for which states more points of the pupil are needed than there
/// may be. `display` has its hogels and directions.
void warnOfPupils(const PanelParams& display, const Session& session, const CommandLine& line);

/// Returns the source of a session's views without texels, after its twin's maps have been read.
/// Prints, unless the job is quiet, what is assumed of them. Throws InputError, Cancelled.
ViewSource unloadedOf(const Session& session, const LightFieldFile& lightField,
                      const CommandLine& line);

/// Returns a new session for the light field that the job's own option names, read as --set
/// specifies. Throws InputError, also for a --set of parameters that it does not have: camera
/// states and their sampling.
OrderedSession sessionAroundSubject(const CommandLine& line);

/// Returns a text such as ", about 4 min" for reading a plain PNG, or another file of as many
/// pixels, on one core; "" for a few seconds.
std::string readingTimeText(const LightFieldFile& file);

/// Prints before a long wait, unless `isQuiet`, that a light field exceeds `memory` and is
/// streamed, and the approximate time.
void announceStreaming(const LightFieldFile& file, std::size_t memory, bool isQuiet);

}  // namespace hogelscope
