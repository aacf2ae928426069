// SPDX-License-Identifier: BSD-3-Clause
// Hashes of files, each computed once for all processes that share an output folder and for a run
// that goes on after a stop.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/progress.h"

namespace hogelscope {

/// A cache of hashes in FOLDER/report.hashes: a line for each file with its XXH3-128,
/// fileIdentity() and path. A file whose identity has changed is hashed again. While one process
/// hashes a file, the others wait.
class FileHashes {
 public:
  /// Opens the cache. Throws InputError if a file of that name is not one.
  explicit FileHashes(const std::filesystem::path& folder);

  /// Returns what contentHash() returns for these files. Throws InputError, Cancelled.
  std::string of(const std::vector<std::filesystem::path>& files, const Progress& progress);

  /// Deletes the cache, after the results have been written: it names every input by its absolute
  /// path, which whoever gets the results need not know.
  void remove();

 private:
  /// Returns a file's current identity: a line of the cache without the hash.
  [[nodiscard]] static std::string identityOf(const std::filesystem::path& file);
  void complete(const std::vector<std::filesystem::path>& files,
                const std::vector<std::string>& identities, const Progress& progress);
  void read();

  std::filesystem::path m_cache;
  std::map<std::string, std::string> m_hashes;  ///< by identity
};

}  // namespace hogelscope
