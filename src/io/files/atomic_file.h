// SPDX-License-Identifier: BSD-3-Clause
// Files that are either complete or absent: they are written without a name, then renamed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/files/random_access_file.h"

namespace hogelscope {

/// A new file: write to descriptor(), then call commit(). Until then `path` is unchanged. The new
/// file has no name before commit(), so nothing is left behind however the program ends. On file
/// systems without unnamed files (NFS, FAT) it has a random, unique name, so that two programs
/// writing one file do not collide.
class AtomicFile {
 public:
  /// Creates the file. If `path` is a symbolic link, its target will be replaced. Throws InputError
  /// if `path` is not a regular file or is in use (FilesInUse), or its folder cannot be written to.
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Returns a descriptor that is open for reading and writing.
  [[nodiscard]] int descriptor() const { return m_descriptor.get(); }
  /// Waits until the file is on the disk, then replaces the old one and keeps its permissions.
  /// Throws InputError.
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

/// Writes a file. Throws InputError (full disk, missing folder).
void writeTextFile(const std::filesystem::path& path, std::string_view text);

/// Writes all of `text` to a file descriptor. Throws InputError that names `path`.
void writeAll(int descriptor, std::string_view text, const std::filesystem::path& path);

/// Waits until everything written is on the disk. Throws InputError that names `path`.
void syncToDisk(int descriptor, const std::filesystem::path& path);

/// Reads a file. Throws InputError (missing, a folder, unreadable, larger than 64 MiB).
std::string readTextFile(const std::filesystem::path& path);

/// Creates a folder and its parents. Throws InputError, also if the folder cannot be written to.
void makeFolder(const std::filesystem::path& folder);

/// Checks a file whose name the program has chosen, before it is replaced or deleted without
/// asking: throws InputError unless `path` is missing, or is a regular file (not a link) that
/// begins with `head`, or with a part of it left by a crash.
void requireOwnFile(const std::filesystem::path& path, std::string_view head);

/// Opens a file for reading and writing, creates it if missing, never follows a symbolic link, and
/// locks it until it is closed; none if another process has the lock. Throws InputError.
std::optional<Descriptor> openLocked(const std::filesystem::path& path, int moreFlags = 0);

/// Removes the temporary files that a killed process left in a folder before naming them. No
/// process may be writing there.
void removeLeftovers(const std::filesystem::path& folder);

/// Whether a process has locked a file by openLocked(); false for a file that cannot be opened.
bool isLocked(const std::filesystem::path& path);

}  // namespace hogelscope
