// SPDX-License-Identifier: BSD-3-Clause
// Runs functions of plugins: whatever they throw becomes one line that names the plugin.
#pragma once

#include <exception>
#include <memory>
#include <new>
#include <string>

#include "core/base/error.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

/// Returns the error of a plugin: "plugin NAME: WHY", one line of some hundred letters at most.
InputError pluginError(const std::string& name, std::string why);

/// Returns what `call` returns. An InputError or Cancelled is the program's own, which the plugin
/// has passed on from a visitor or a listener; anything else becomes an InputError.
template <class Call>
decltype(auto) guarded(const std::string& name, Call call) {
  try {
    return call();
  } catch (const InputError&) {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw pluginError(name, "there is not enough memory");
  } catch (const std::exception& error) {
    throw pluginError(name, error.what() == nullptr ? "" : error.what());
  } catch (...) {
    throw pluginError(name, "throws what is not a std::exception");
  }
}

// Each returns the object with every function guarded, and with its results checked as far as the
// program's memory depends on them. Destructors of plugins must not throw (C++ ends the process).

std::unique_ptr<plugin::ContentSource> guardedContent(
    std::string name, std::unique_ptr<plugin::ContentSource> content);
std::unique_ptr<plugin::HogelLens> guardedLens(std::string name,
                                               std::unique_ptr<plugin::HogelLens> lens);
std::unique_ptr<plugin::Metric> guardedMetric(std::string name,
                                              std::unique_ptr<plugin::Metric> metric);

}  // namespace hogelscope
