// SPDX-License-Identifier: BSD-3-Clause
// Twins in documents: a session's "twin", which is the twin itself or the name of its own document,
// and those documents.
#pragma once

#include <filesystem>
#include <string>

#include "core/panel/twin_params.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

/// Reads a session's twin; `path` is its place in the document. Throws InputError.
TwinParams readTwin(const Json& object, const std::string& path = "twin");
/// Returns the parts of a twin that are not as designed.
Json writtenTwin(const TwinParams& twin);

/// Reads a twin's document: the twin itself, or an object with it as "twin". Its files are named as
/// from the current folder. Throws InputError.
TwinParams loadTwin(const std::filesystem::path& file);
/// Returns a twin's document as it would be saved in a file, the names of its files relative to it.
/// Throws InputError that names the file.
std::string textFor(const std::filesystem::path& file, const TwinParams& twin);
/// Writes that document. Throws InputError.
void saveTwin(const std::filesystem::path& file, const TwinParams& twin);

/// Replaces the name of a twin's document in a session, if it has one, by that document's content,
/// with files as from the session's folder. Returns the name, or "". Throws InputError.
std::string embedTwin(Json& session, const std::filesystem::path& folder);

}  // namespace hogelscope
