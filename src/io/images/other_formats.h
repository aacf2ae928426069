// SPDX-License-Identifier: BSD-3-Clause
// Files that people bring and that are not read, by the formats that can be recognised.
#pragma once

#include <filesystem>
#include <string>

namespace hogelscope {

/// Returns what a file of a format that is not read is, and what to do with it, such as "is an
/// archive: unpack it and open the folder of its pictures"; "" for all other files. Looks at the
/// first bytes, and at the extension where a format has no mark of its own. Throws InputError if
/// the file cannot be opened.
std::string adviceOnFormat(const std::filesystem::path& file);

}  // namespace hogelscope
