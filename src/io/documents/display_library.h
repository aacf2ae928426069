// SPDX-License-Identifier: BSD-3-Clause
// A folder of displays from public sources: sessions, and library.json, which names them:
// {"hogelscopeDisplays": 1, "displays": [{"file", "name", "source", "assumed"}, …]}.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hogelscope {

struct LibraryDisplay {
  std::string file;     ///< the session's name in the folder, without an ending
  std::string name;     ///< for people
  std::string source;   ///< what is known, and from where
  std::string assumed;  ///< what is not known; "" if nothing
};

/// Reads library.json. Throws InputError that names the file.
std::vector<LibraryDisplay> loadDisplayLibrary(const std::filesystem::path& file);

}  // namespace hogelscope
