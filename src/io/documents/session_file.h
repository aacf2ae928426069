// SPDX-License-Identifier: BSD-3-Clause
// Session documents: reading, and writing without losing the old one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/optics/session.h"
#include "io/documents/calibration_file.h"
#include "io/opening/light_field_order.h"

namespace hogelscope {

/// Reads a session. `overrides` are of the form section.field=value, value as in JSON (a text needs
/// no quotes); camera, intrinsics, distortion and psf apply to every state. A calibration applies
/// to every state before them. The light field's file becomes relative to the current folder
/// instead of the document. Throws InputError that names the document.
Session loadSession(const std::filesystem::path& file,
                    const std::vector<std::string>& overrides = {},
                    const std::optional<Calibration>& calibration = {});

/// Reads the text of a session, which names its files relative to `folder`; otherwise as
/// loadSession(). Throws InputError that names no document.
Session parseSession(const std::string& text, const std::filesystem::path& folder,
                     const std::vector<std::string>& overrides = {},
                     const std::optional<Calibration>& calibration = {});

/// Returns the document, with the light field's file unchanged.
std::string textOf(const Session& session);

/// Writes a session, the light field's file relative to the document. Throws InputError.
void saveSession(const std::filesystem::path& file, const Session& session);

/// Reads the camera states of a session document, which needs only them and its version. Throws
/// InputError that names the document.
std::vector<CameraState> loadStates(const std::filesystem::path& file);

/// Appends states, under free names, to a session document, and keeps everything else in it; the
/// file is replaced atomically. Throws InputError.
void appendStates(const std::filesystem::path& file, const std::vector<CameraState>& states);

/// A display with one state in front of it, whose content is the built-in scene.
Session newSession();

/// Makes a session around a light field: an image, a quilt by its name, a folder of views, or a
/// mesh, which is read. The display has its shape; one state is in front of it. Views get the order
/// and shear that their pictures say, unless the overrides do. Of a hogel image the hogels and
/// directions are found in the picture, or remain to be given; a few large tiles are those of a
/// quilt or a mosaic. A store has its display. `overrides` as above. Throws InputError, or
/// Cancelled while a mesh is read or views are looked at.
Session sessionAround(const std::string& file, const std::vector<std::string>& overrides = {},
                      const Progress& progress = {});

/// A session around a light field, and what was found out about the order of its views.
struct OrderedSession {
  Session session;
  LightFieldOrder order;
  /// A line for the user on what nobody has said of hogels and directions, but the picture shows;
  /// "" if there is none.
  std::string assumed;
  Sureness hogels = Sureness::sure;  ///< of that
};

/// The same, for those who tell the user about the order.
OrderedSession orderedSessionAround(const std::string& file,
                                    const std::vector<std::string>& overrides = {},
                                    const Progress& progress = {});

/// Whether the name is that of a session document: FILE.hogelscope or FILE.json.
bool isSessionFile(const std::filesystem::path& file);

/// Returns the session with another light field, for comparisons: an image, a folder of views, or a
/// session, of which the display is used too. Throws InputError.
Session withLightField(const Session& session, const std::string& file);

}  // namespace hogelscope
