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

/// Throws InputError where one of the files to write is one of those to read, by whatever name or
/// link: to be asked before any work. Missing files are no reason.
void checkOutputs(const std::vector<std::filesystem::path>& outputs,
                  const std::vector<std::filesystem::path>& inputs);

}  // namespace hogelscope
