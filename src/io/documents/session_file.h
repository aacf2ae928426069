// SPDX-License-Identifier: BSD-3-Clause
// Session documents: loading whole or not at all, saving without losing the old one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/optics/session.h"
#include "io/documents/calibration_file.h"

namespace hogelscope {

/// `overrides` are of the form section.field=value, value as in JSON (a text needs no quotes);
/// camera, intrinsics, distortion and psf go to every state. A calibration goes to every state
/// before them. The light field's file becomes relative to the current folder instead of the
/// document. Throws InputError that names the document.
Session loadSession(const std::filesystem::path& file,
                    const std::vector<std::string>& overrides = {},
                    const std::optional<Calibration>& calibration = {});

/// The document, with the light field's file as it is.
std::string textOf(const Session& session);

/// The light field's file is written relative to the document. Throws InputError.
void saveSession(const std::filesystem::path& file, const Session& session);

/// The camera states of a session document, which needs nothing else but its version. Throws
/// InputError that names the document.
std::vector<CameraState> loadStates(const std::filesystem::path& file);

/// Adds states, with free names, to a session document, and keeps everything else in it; the whole
/// file is replaced at once. Throws InputError.
void appendStates(const std::filesystem::path& file, const std::vector<CameraState>& states);

/// A new session around a light field: an image, a quilt by its name, or a folder of views. The
/// display has its shape; one state is in front of it. A hogel image leaves the hogels and
/// directions to be given; a store has its display. `overrides` as above. Throws InputError.
Session sessionAround(const std::string& file, const std::vector<std::string>& overrides = {});

/// Is it a session document, by its name?
bool isSessionFile(const std::filesystem::path& file);

/// Another light field in the place of the session's own, for comparing: an image, a folder of
/// views, or a session, whose display comes with it. Throws InputError.
Session withLightField(const Session& session, const std::string& file);

}  // namespace hogelscope
