// SPDX-License-Identifier: BSD-3-Clause
// Files that OBJ, MTL and PLY name, which may have been written under Windows.
#pragma once

#include <string>

namespace hogelscope::mesh {

struct FoundFile {
  std::string path;          ///< where it is, or should be
  bool isThere = false;      ///< a regular file
  bool isElsewhere = false;  ///< another folder than the named one
};

/// Looks for a file that another file names: as it is written, then with slashes for backslashes,
/// with letters of the other case, and without quotation marks, then by the last parts of its path
/// in the other file's folder, since a path of another machine leads nowhere.
FoundFile foundBesides(const std::string& file, const std::string& name);

}  // namespace hogelscope::mesh
