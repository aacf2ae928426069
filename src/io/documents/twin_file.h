// SPDX-License-Identifier: BSD-3-Clause
// Twins in documents: a session's "twin", which is the twin itself or the name of its own document,
// and those documents.
#pragma once

#include <filesystem>
#include <string>

#include "core/panel/twin_params.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

/// Reads a twin's document: the twin itself, or an object with it as "twin". Its files are named as
/// from the current folder. Throws InputError.
TwinParams loadTwin(const std::filesystem::path& file);
/// Returns a twin's document as it would be saved in a file, the names of its files relative to it.
/// Throws InputError that names the file.
std::string textFor(const std::filesystem::path& file, const TwinParams& twin);
/// Writes that document. Throws InputError.
void saveTwin(const std::filesystem::path& file, const TwinParams& twin);

/// Returns the twin of the document `name` in a session's folder, its files as from that folder.
/// Throws InputError.
Json twinObject(const std::string& name, const std::filesystem::path& folder);

}  // namespace hogelscope
