// SPDX-License-Identifier: BSD-3-Clause
// The folders that are searched for plugins, and the installed plugins, as described by
// plugin.json. Everything is checked before any byte of a library is loaded, because dlopen() of a
// truncated library ends the process.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hogelscope {

/// Adds a folder for the whole process; call it before threads use plugins. It is searched before
/// the program's own folders, in the order of the calls. Throws InputError if it is not a folder.
void addPluginFolder(const std::filesystem::path& folder);

/// Returns the folders of addPluginFolder(), the user's own, the installation's and the build
/// tree's, in this order, and those of the user for older interfaces. All except the first may be
/// missing. Each plugin has a folder in one of them.
std::vector<std::filesystem::path> pluginFolders();

enum class PluginKind { content, lens, metric };
constexpr std::array<std::string_view, 3> pluginKindNames{"content", "lens", "metric"};
std::string nameOf(PluginKind kind);

struct FoundPlugin {
  std::string name;  ///< that of the folder if missing in plugin.json
  std::string version;
  std::vector<PluginKind> kinds;
  std::filesystem::path folder;   ///< the plugin's own folder
  std::filesystem::path library;  ///< in that folder
  std::string refusal;            ///< why it cannot be used, in one line; empty if it can
};

/// Returns the plugins in pluginFolders(), by folder, then by name. A later plugin of the same name
/// is rejected. Loads nothing and throws nothing; errors become refusals.
std::vector<FoundPlugin> listPlugins();

/// Returns plugin.json and the library of each of these plugins that is found; a session's other
/// names, such as those of built-in content, are no plugins.
std::vector<std::filesystem::path> pluginFiles(const std::vector<std::string>& names);

}  // namespace hogelscope
