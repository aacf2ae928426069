// SPDX-License-Identifier: BSD-3-Clause
// --plugins: lists the plugins that are found.
#include <iostream>

#include "cli/jobs.h"
#include "core/base/text.h"
#include "io/files/folders.h"
#include "io/plugins/plugin_list.h"

namespace hogelscope {

namespace {

using Cells = std::array<std::string, 4>;

std::string kindsText(const FoundPlugin& plugin) {
  std::string text;
  for (const PluginKind kind : plugin.kinds) text += (text.empty() ? "" : ", ") + nameOf(kind);
  return text;
}

/// Prints a table; all columns except the last are as wide as their longest cell.
void print(const std::vector<Cells>& rows) {
  Cells widest;
  for (const Cells& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k)
      if (row[k].size() > widest[k].size()) widest[k] = row[k];
  for (const Cells& row : rows) {
    for (std::size_t k = 0; k + 1 < row.size(); ++k)
      std::cout << row[k] << std::string(widest[k].size() - row[k].size() + 2, ' ');
    std::cout << row.back() << "\n";
  }
}

int runPlugins(const CommandLine& /*line*/) {
  std::vector<Cells> rows{{"plugin", "version", "kinds", "folder, or why it is refused"}};
  for (const FoundPlugin& plugin : listPlugins()) {
    const bool isUsable = plugin.refusal.empty();
    rows.push_back({printable(plugin.name),
                    plugin.version.empty() ? "-" : printable(plugin.version),
                    isUsable ? kindsText(plugin) : "refused",
                    printable(isUsable ? plugin.folder.string() : plugin.refusal)});
  }
  print(rows);
  for (const std::filesystem::path& folder : pluginFolders())
    std::cout << "looked in " << printable(folder.string())
              << (isFolder(folder) ? "" : " (missing)") << "\n";
  return 0;
}

}  // namespace

Job pluginsJob() {
  return {.name = "plugins",
          .help = "Lists the plugins that are found, and says why any is refused.",
          .details = "Nothing of them is loaded: a session loads those that it names.",
          .examples =
              "  hogelscope --plugins\n"
              "  hogelscope --plugins --plugins-path build/plugins-3\n",
          .takes = {"plugins-path"},
          .run = runPlugins};
}

}  // namespace hogelscope
