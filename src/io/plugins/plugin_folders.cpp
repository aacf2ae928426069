// SPDX-License-Identifier: BSD-3-Clause
// The folders that are searched for plugins. None is a path of the machine that built the program.
#include "io/plugins/plugin_folders.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/error.h"
#include "io/files/folders.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path>& addedFolders() {
  static std::vector<fs::path> folders;
  return folders;
}

}  // namespace

void addPluginFolder(const fs::path& folder) {
  if (!isFolder(folder))
    throw InputError(folder.string(), "", "is not a folder; each plugin is a folder in it");
  std::error_code error;
  addedFolders().push_back(fs::canonical(folder, error));
}

std::vector<fs::path> pluginFolders() {
  const std::string ours = "plugins-" + std::to_string(plugin::abi);
  std::vector<fs::path> folders = addedFolders();
  const char* const home = std::getenv("HOME");
  const bool hasHome = home != nullptr && fs::path(home).is_absolute();
  const fs::path own = hasHome ? fs::path(home) / ".local/lib/hogelscope" : fs::path();
  if (hasHome) folders.push_back(own / ours);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path prefix = program.parent_path().parent_path();  // the program is in PREFIX/bin
    folders.push_back(prefix / HOGELSCOPE_LIBRARIES / "hogelscope" / ours);
    folders.push_back(prefix / ours);
  }
  // Plugins for older programs are rejected by their number, with advice.
  for (auto older = plugin::abi - 1; hasHome && older > 0; --older)
    if (const fs::path folder = own / ("plugins-" + std::to_string(older)); isFolder(folder))
      folders.push_back(folder);
  std::vector<fs::path> once;
  for (const fs::path& folder : folders)
    if (std::ranges::find(once, folder) == once.end()) once.push_back(folder);
  return once;
}

}  // namespace hogelscope
