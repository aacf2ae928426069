// SPDX-License-Identifier: BSD-3-Clause
// Returns what is embedded in the program for its pages.
#pragma once

#include <string_view>

namespace hogelscope {

/// Returns a file of resources/web; "" if there is no such one.
std::string_view pageFile(std::string_view name);

/// Returns the engine, WebAssembly by gzip; "" in a program that was built without it.
std::string_view pageEngine();

}  // namespace hogelscope
