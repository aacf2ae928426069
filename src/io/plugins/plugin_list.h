// SPDX-License-Identifier: BSD-3-Clause
// The installed plugins, as described by plugin.json. Everything is checked before any byte of a
// library is loaded, because dlopen() of a truncated library ends the process.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hogelscope {

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

}  // namespace hogelscope
