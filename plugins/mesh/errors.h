// SPDX-License-Identifier: BSD-3-Clause
// Messages of the readers about errors and omitted parts.
#pragma once

#include <string>
#include <vector>

namespace hogelscope::mesh {

/// Throws std::runtime_error with one line, "FILE: WHAT: WHY". Control characters become '?'.
[[noreturn]] void fail(const std::string& file, const std::string& what, const std::string& why);

/// Returns one name for all names of a file: absolute, without links, "." and "..".
std::string sameName(const std::string& path);

/// Returns a note: "Its WHAT a, b, … are not shown."
std::string leftOut(const std::string& what, const std::vector<std::string>& names);

/// Returns a name from a file, shortened for a message.
std::string shortName(const std::string& name);

}  // namespace hogelscope::mesh
