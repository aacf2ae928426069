// SPDX-License-Identifier: BSD-3-Clause
// Files that are there whole or not at all: written beside their place, then renamed over it.
#pragma once

#include <filesystem>
#include <string_view>

namespace hogelscope {

/// Write to `temporary()`, then `commit()`. Without it nothing is left.
class AtomicFile {
 public:
  /// `path` may be a link: its target is what is replaced.
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// In the same folder, with the same extension.
  [[nodiscard]] const std::filesystem::path& temporary() const { return m_temporary; }
  /// Throws InputError where the file cannot be put in place.
  void commit();

 private:
  std::filesystem::path m_path;
  std::filesystem::path m_temporary;
};

/// Writes `text` and waits until the disk has it. Throws InputError (full disk, missing folder).
void writeTextFile(const std::filesystem::path& path, std::string_view text);

/// Throws InputError (missing, a folder, unreadable, larger than 64 MiB).
std::string readTextFile(const std::filesystem::path& path);

/// Makes the folder and those above it. Throws InputError, also where nothing can be written there.
void makeFolder(const std::filesystem::path& folder);

}  // namespace hogelscope
