// SPDX-License-Identifier: BSD-3-Clause
// How the readers say what is wrong, and the bytes of a file.
#pragma once

#include <string>
#include <vector>

namespace hogelscope::mesh {

/// Throws std::runtime_error with one line, "FILE: WHAT: WHY". Letters that would break the line or
/// a terminal become '?'.
[[noreturn]] void fail(const std::string& file, const std::string& what, const std::string& why);

/// Returns what the file holds, or throws.
std::string readBytes(const std::string& file);

/// A name out of a file, short enough for a message.
std::string shortName(const std::string& name);

}  // namespace hogelscope::mesh
