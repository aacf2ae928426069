// SPDX-License-Identifier: BSD-3-Clause
// Runs functions of plugins and converts their exceptions to one line that names the plugin.
#pragma once

#include <exception>
#include <memory>
#include <new>
#include <string>

#include "core/base/error.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

/// Returns the error of a plugin, "plugin NAME: WHY", on one line of at most some hundred
/// characters.
InputError pluginError(const std::string& name, std::string why);

/// Returns the result of `call`. InputError and Cancelled come from the program's own visitors and
/// listeners and are rethrown; any other exception becomes an InputError.
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

// Each function returns the object with every function guarded, and with its results checked as far
// as memory safety requires. Destructors of plugins must not throw (C++ ends the process).

std::unique_ptr<plugin::ContentSource> guardedContent(
    std::string name, std::unique_ptr<plugin::ContentSource> content);
std::unique_ptr<plugin::HogelLens> guardedLens(std::string name,
                                               std::unique_ptr<plugin::HogelLens> lens);
std::unique_ptr<plugin::Metric> guardedMetric(std::string name,
                                              std::unique_ptr<plugin::Metric> metric);

}  // namespace hogelscope
