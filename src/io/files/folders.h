// SPDX-License-Identifier: BSD-3-Clause
// Queries of files and folders that throw only InputError.
#pragma once

#include <filesystem>
#include <vector>

namespace hogelscope {

/// Whether a path is a folder; false if unknown, because reading the path will then report the
/// reason.
bool isFolder(const std::filesystem::path& path);

/// Returns the entries of a folder, sorted by name. Throws InputError (missing, no permission).
std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder);

/// Returns the entries that are not folders, sorted by name, including broken links. Throws
/// InputError.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder);

}  // namespace hogelscope
