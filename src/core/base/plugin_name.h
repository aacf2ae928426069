// SPDX-License-Identifier: BSD-3-Clause
// The names of plugins, which are names of folders, of session entries and of CSV columns too.
#pragma once

#include <string>

namespace hogelscope {

/// Throws InputError at `path` unless the name is 1 to 40 small letters, digits and "-", a letter
/// first.
void checkPluginName(const std::string& name, const std::string& path);

}  // namespace hogelscope
