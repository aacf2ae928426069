// SPDX-License-Identifier: BSD-3-Clause
// The files that this process reads, so that no result replaces one of them: what writes a file
// asks here, before its work and when it gives the file its name.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

namespace hogelscope {

/// Marks files as read for as long as it lives, for the whole process. Files that are missing are
/// ignored, as is what is not a file. Thread-safe.
class FilesInUse {
 public:
  explicit FilesInUse(const std::vector<std::filesystem::path>& files);
  FilesInUse(const FilesInUse&) = delete;
  FilesInUse& operator=(const FilesInUse&) = delete;
  ~FilesInUse();

 private:
  std::vector<std::pair<unsigned long, unsigned long>> m_marked;  ///< device and inode
};

/// Throws InputError if one of the outputs is a file in use, under any name or link, or if two of
/// them are one file. Call it before any work.
void checkOutputs(const std::vector<std::filesystem::path>& outputs);

/// Throws InputError if a file that is about to be replaced is in use. AtomicFile and stores ask.
void requireUnused(const std::filesystem::path& output);

}  // namespace hogelscope
