// SPDX-License-Identifier: BSD-3-Clause
// Loads plugins: plugin.json, then the library, then the numbers in it, then its functions.
#include "io/plugins/plugin_library.h"

#include <dlfcn.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/content/capture_content.h"
#include "core/content/scene_content.h"
#include "io/plugins/plugin_guard.h"
#include "io/plugins/plugin_list.h"

namespace hogelscope {

namespace {

/// Returns the first plugin of this name in listPlugins(). Throws InputError.
FoundPlugin findPlugin(const std::string& name) {
  std::vector<FoundPlugin> plugins = listPlugins();
  std::vector<std::string_view> names;
  for (FoundPlugin& found : plugins) {
    if (found.name == name) return std::move(found);
    names.emplace_back(found.name);
  }
  const std::string_view nearest = nearestName(name, names);
  if (!nearest.empty())
    throw pluginError(name, "is not installed; did you mean " + std::string(nearest) + "?");
  std::string looked;
  for (const std::filesystem::path& folder : pluginFolders())
    looked += (looked.empty() ? "" : ", ") + folder.string();
  throw pluginError(name, "is not installed; looked in " + looked);
}

const plugin::Entry& openLibrary(const FoundPlugin& found) {
  void* library = ::dlopen(found.library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw pluginError(found.name, ::dlerror());
  const void* symbol = ::dlsym(library, "hogelscope_plugin");
  if (symbol == nullptr)
    throw pluginError(found.name, found.library.string() +
                                      " has no symbol hogelscope_plugin: it needs the line "
                                      "HOGELSCOPE_PLUGIN(…)");
  return *static_cast<const plugin::Entry*>(symbol);
}

/// Checks the library against plugin.json, which may have been written for another one.
void checkEntry(const FoundPlugin& found, const plugin::Entry& entry) {
  const auto refuseOther = [&](bool isSame, const char* what) {
    if (!isSame)
      throw pluginError(found.name, found.library.string() + ": its " + what +
                                        " is not that of its plugin.json: build the plugin again");
  };
  const auto says = [](const char* text, const std::string& wanted) {
    return text != nullptr && text == wanted;
  };
  refuseOther(entry.abi == plugin::abi, "abi");
  refuseOther(says(entry.build, HOGELSCOPE_PLUGIN_BUILD), "build");
  refuseOther(says(entry.name, found.name), "name");
}

/// Returns the object that the plugin's function creates; `what` is its kind.
template <class Object>
std::unique_ptr<Object> made(const std::string& name, Object* (*function)(), PluginKind kind) {
  const std::string what = nameOf(kind);
  if (function == nullptr) throw pluginError(name, "has no " + what);
  Object* object = guarded(name, [&] { return function(); });
  if (object == nullptr) throw pluginError(name, "makes no " + what);
  return std::unique_ptr<Object>(object);
}

}  // namespace

std::unique_ptr<plugin::ContentSource> PluginLibrary::makeContent() const {
  return guardedContent(m_name, made(m_name, m_entry->content, PluginKind::content));
}

std::unique_ptr<plugin::HogelLens> PluginLibrary::makeLens() const {
  return guardedLens(m_name, made(m_name, m_entry->lens, PluginKind::lens));
}

std::unique_ptr<plugin::Metric> PluginLibrary::makeMetric() const {
  return guardedMetric(m_name, made(m_name, m_entry->metric, PluginKind::metric));
}

PluginLibrary loadPlugin(const std::string& name, PluginKind kind) {
  const FoundPlugin found = findPlugin(name);
  if (!found.refusal.empty()) throw pluginError(name, found.refusal);
  if (std::ranges::find(found.kinds, kind) == found.kinds.end())
    throw pluginError(name, "has no " + nameOf(kind) + "; its plugin.json says what it has");
  const plugin::Entry& entry = openLibrary(found);
  checkEntry(found, entry);
  return {name, entry};
}

ContentParams contentParamsOf(const std::string& source) {
  if (source == "scene") return ContentParams([] { return std::make_unique<SceneContent>(); });
  if (source == CaptureContent::sourceName)
    return ContentParams([] { return std::make_unique<CaptureContent>(); });
  const PluginLibrary library = loadPlugin(source, PluginKind::content);
  return ContentParams([library] { return library.makeContent(); });
}

}  // namespace hogelscope
