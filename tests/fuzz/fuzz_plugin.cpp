// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes plugin.json. Nothing is loaded: a library from hostile hands cannot be made harmless.
#include "io/plugins/plugin_list.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

namespace {

/// A folder with one plugin, whose library is four bytes long.
void makePlugin() {
  std::filesystem::create_directories(folder() / "example");
  fileOf("example/example.so",
         "\x7f"
         "ELF");
  addPluginFolder(folder());
}

}  // namespace

void fuzz(std::string_view input) {
  [[maybe_unused]] static const bool isMade = (makePlugin(), true);
  fileOf("example/plugin.json", input);
  for (const FoundPlugin& plugin : listPlugins()) {
    const bool isUsable = plugin.refusal.empty();
    require(!isUsable || (!plugin.kinds.empty() && plugin.library == plugin.folder / "example.so"));
    if (!isUsable) mayRefuse([&] { throw InputError("", plugin.refusal); });
    require(plugin.refusal.find('\n') == std::string::npos);
  }
}
