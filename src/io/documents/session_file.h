// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes session documents; the old one is kept until the new one is complete.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/cameras/calibrated_camera.h"
#include "core/optics/session.h"

namespace hogelscope {

/// Reads a session. `overrides` are of the form section.field=value, value as in JSON (a text needs
/// no quotes); those of a state apply to every state. A calibration is
/// applied to every state before the overrides. The light field's file becomes relative to the
/// current folder instead of the document. Throws InputError that names the document.
Session loadSession(const std::filesystem::path& file,
                    const std::vector<std::string>& overrides = {},
                    const std::optional<Calibration>& calibration = {});

/// Reads the text of a session, whose file names are relative to `folder`; otherwise as
/// loadSession(). Throws InputError that names no document.
Session parseSession(const std::string& text, const std::filesystem::path& folder,
                     const std::vector<std::string>& overrides = {},
                     const std::optional<Calibration>& calibration = {});

/// Returns the document, with the light field's file unchanged.
std::string textOf(const Session& session);

/// Returns the document as it would be saved in a file, other files relative to it. Throws
/// InputError that names the file.
std::string textFor(const std::filesystem::path& file, const Session& session);

/// Writes a session, the light field's file relative to the document. Throws InputError.
void saveSession(const std::filesystem::path& file, const Session& session);

/// Reads the camera states of a session document, which needs only them and its version. Throws
/// InputError that names the document.
std::vector<CameraState> loadStates(const std::filesystem::path& file);

/// Appends states, under free names, to a session document, and keeps everything else in it; the
/// file is replaced atomically. Throws InputError.
void appendStates(const std::filesystem::path& file, const std::vector<CameraState>& states);

/// Returns a session of a display that shows the built-in scene, with one state in front of it.
Session newSession();

/// Returns the session with overrides as above. Throws InputError that names the light field's
/// file.
Session overridden(const Session& session, const std::vector<std::string>& overrides);

/// Whether the name is that of a session document: FILE.hogelscope or FILE.json.
bool isSessionFile(const std::filesystem::path& file);

/// Whether a file is a session, not a light field that a session is made around.
bool isSessionDocument(const std::filesystem::path& file);

/// Returns all files that a session's results depend on, but for those of its light field: the
/// tables of its lens, its twin with its maps, calibrations, its plugins.
std::vector<std::filesystem::path> sessionFiles(const Session& session);

}  // namespace hogelscope
