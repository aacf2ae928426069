// SPDX-License-Identifier: BSD-3-Clause
// Loads plugins.
#pragma once

#include <memory>
#include <string>

#include "core/light_field/layout_params.h"
#include "io/plugins/plugin_list.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

/// The library of a plugin. It stays loaded until the process ends, so copies and created objects
/// have no limited lifetime.
class PluginLibrary {
 public:
  // Each function creates an object whose functions throw only InputError ("plugin NAME: …") and
  // Cancelled. Throws InputError, also if the plugin does not offer the kind.

  [[nodiscard]] std::unique_ptr<plugin::ContentSource> makeContent() const;
  [[nodiscard]] std::unique_ptr<plugin::HogelLens> makeLens() const;
  [[nodiscard]] std::unique_ptr<plugin::Metric> makeMetric() const;

 private:
  friend PluginLibrary loadPlugin(const std::string& name, PluginKind kind);
  PluginLibrary(std::string name, const plugin::Entry& entry)
      : m_name(std::move(name)), m_entry(&entry) {}

  std::string m_name;
  const plugin::Entry* m_entry;
};

/// Loads the plugin of this name, which must offer the kind. Throws InputError if there is none or
/// it cannot be used.
PluginLibrary loadPlugin(const std::string& name, PluginKind kind);

/// Returns the parameters of content by its name in sessions: "scene", or a plugin's. Throws
/// InputError for an unknown name, and what is wrong with a plugin.
ContentParams contentParamsOf(const std::string& source);

}  // namespace hogelscope
