// SPDX-License-Identifier: BSD-3-Clause
// The folders that are searched for plugins.
#pragma once

#include <filesystem>
#include <vector>

namespace hogelscope {

/// Adds a folder for the whole process; call it before threads use plugins. It is searched before
/// the program's own folders, in the order of the calls. Throws InputError if it is not a folder.
void addPluginFolder(const std::filesystem::path& folder);

/// Returns the folders of addPluginFolder(), the user's own, the installation's and the build
/// tree's, in this order, and those of the user for older interfaces. All except the first may be
/// missing. Each plugin has a folder in one of them.
std::vector<std::filesystem::path> pluginFolders();

}  // namespace hogelscope
