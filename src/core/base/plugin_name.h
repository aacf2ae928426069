// SPDX-License-Identifier: BSD-3-Clause
// Plugin names, which are also names of folders, session entries and CSV columns.
#pragma once

#include <string>

namespace hogelscope {

/// Throws InputError at `path` unless the name is 1 to 40 lower-case letters, digits and "-",
/// starting with a letter.
void checkPluginName(const std::string& name, const std::string& path);

}  // namespace hogelscope
