// SPDX-License-Identifier: BSD-3-Clause
// What plugin.json says of each plugin that is installed. It is checked before any byte of a
// library is loaded, since dlopen() of a truncated library ends the process.
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
  std::string name;  ///< the folder's, where plugin.json does not say it
  std::string version;
  std::vector<PluginKind> kinds;
  std::filesystem::path folder;   ///< the plugin's own
  std::filesystem::path library;  ///< in that folder
  std::string refusal;            ///< one line that says why it cannot be used; empty if it can
};

/// Returns the plugins in pluginFolders(), by folder, then by name. Of two with one name the later
/// is refused. Loads nothing and throws nothing: what is wrong is a refusal.
std::vector<FoundPlugin> listPlugins();

}  // namespace hogelscope
