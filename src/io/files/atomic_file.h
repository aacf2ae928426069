// SPDX-License-Identifier: BSD-3-Clause
// Files that are there whole or not at all: written without a name, then put in place.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/files/random_access_file.h"

namespace hogelscope {

/// Write to `descriptor()`, then `commit()`. Until then the file at `path` stays as it is.
///
/// The new file has no name before commit(), so that nothing is left behind however the program
/// ends. On file systems without such files (NFS, FAT) it has a random name that nobody else can
/// have: two programs that write one file never meet.
class AtomicFile {
 public:
  /// If `path` is a symbolic link, its target is what is replaced. Throws InputError: `path` is not
  /// a regular file, or its folder cannot be written to.
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Open for reading and writing.
  [[nodiscard]] int descriptor() const { return m_descriptor.get(); }
  /// Waits until the disk has the file, then puts it in place of the old one, whose permissions it
  /// takes over. Throws InputError.
  void commit();

 private:
  void openNamed();
  void giveName();
  void takeName(const std::filesystem::path& name);
  void dropName();

  std::filesystem::path m_path;
  std::filesystem::path m_temporary;  ///< empty: the file has no name
  Descriptor m_descriptor;
};

/// Throws InputError (full disk, missing folder).
void writeTextFile(const std::filesystem::path& path, std::string_view text);

/// Writes all of `text` to a file descriptor. Throws InputError that names `path`.
void writeAll(int descriptor, std::string_view text, const std::filesystem::path& path);

/// Waits until the disk has what was written. Throws InputError that names `path`.
void syncToDisk(int descriptor, const std::filesystem::path& path);

/// Throws InputError (missing, a folder, unreadable, larger than 64 MiB).
std::string readTextFile(const std::filesystem::path& path);

/// Makes the folder and those above it. Throws InputError, also where nothing can be written there.
void makeFolder(const std::filesystem::path& folder);

/// For files whose names we choose ourselves, and replace or delete without asking: throws
/// InputError unless `path` is missing, or is a regular file (not a link) that begins with `head`,
/// or with the part of it that a crash left.
void requireOurs(const std::filesystem::path& path, std::string_view head);

/// Opens a file for reading and writing, made if missing, never a symbolic link, and locks it for
/// this process until it is closed; none where another process has the lock. Throws InputError.
std::optional<Descriptor> openLocked(const std::filesystem::path& path, int moreFlags = 0);

}  // namespace hogelscope
