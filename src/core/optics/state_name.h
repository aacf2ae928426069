// SPDX-License-Identifier: BSD-3-Clause
// The name of a camera state, which is also the name of its picture's file.
#pragma once

#include <string>

namespace hogelscope {

/// Throws InputError at `path` + ".name" for a name that is no file's name on every system, or that
/// reads as another one: empty, too long, not UTF-8, with control or bidirectional characters.
void checkStateName(const std::string& name, const std::string& path);

/// The same for names that differ in case only, which many file systems do not tell apart.
std::u32string caseFolded(const std::string& name);

}  // namespace hogelscope
