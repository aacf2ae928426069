// SPDX-License-Identifier: BSD-3-Clause
// Hashes of files, each computed once for all processes that share an output folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/progress.h"

namespace hogelscope {

/// FOLDER/report.hashes keeps each file's XXH3-128 by fileIdentity() and path, a line each; a file
/// whose identity is another is hashed again. While one process reads a file that is not in it, the
/// others wait.
class FileHashes {
 public:
  /// Throws InputError where a file of that name is another.
  explicit FileHashes(const std::filesystem::path& folder);

  /// Returns what contentHash() returns for these files. Throws InputError, Cancelled.
  std::string of(const std::vector<std::filesystem::path>& files, const Progress& progress);

 private:
  /// A file as it is now: a line of the cache, but for the hash.
  [[nodiscard]] static std::string identityOf(const std::filesystem::path& file);
  void complete(const std::vector<std::filesystem::path>& files,
                const std::vector<std::string>& identities, const Progress& progress);
  void read();

  std::filesystem::path m_cache;
  std::map<std::string, std::string> m_hashes;  ///< by identity
};

}  // namespace hogelscope
