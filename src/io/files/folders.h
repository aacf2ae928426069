// SPDX-License-Identifier: BSD-3-Clause
// Queries of files and folders that throw only InputError.
#pragma once

#include <filesystem>
#include <vector>

namespace hogelscope {

/// Returns false if it is unknown: reading the path will then throw the reason.
bool isFolder(const std::filesystem::path& path);

/// Returns the entries of a folder, sorted by name. Throws InputError (missing, no permission).
std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder);

/// Returns the entries that are no folders, sorted by name; links that lead nowhere, too. Throws
/// InputError.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder);

}  // namespace hogelscope
