// SPDX-License-Identifier: BSD-3-Clause
// Looking at files and folders without exceptions other than ours.
#pragma once

#include <filesystem>
#include <vector>

namespace hogelscope {

/// False where that cannot be known: reading the path then throws what is wrong.
bool isFolder(const std::filesystem::path& path);

/// What a folder holds, sorted by name. Throws InputError (missing, no permission).
std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder);

}  // namespace hogelscope
