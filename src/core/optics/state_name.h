// SPDX-License-Identifier: BSD-3-Clause
// The name of a camera state, which is also the name of its image file.
#pragma once

#include <string>

namespace hogelscope {

/// Throws InputError at `path` + ".name" for a name that is not a valid file name on every system,
/// or looks like another one: empty, too long, not UTF-8, with control or bidirectional characters.
void checkStateName(const std::string& name, const std::string& path);

/// Returns a key that is equal for names that differ only in case, which many file systems do not
/// distinguish.
std::u32string caseFolded(const std::string& name);

}  // namespace hogelscope
