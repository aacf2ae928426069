// SPDX-License-Identifier: BSD-3-Clause
// Solved rows of hogels on the disk, so that a run goes on after a stop and several processes share
// it: a file for each row in a folder beside the result.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/shard.h"

namespace hogelscope {

class SolvedRows {
 public:
  /// `key` is unique to the problem: rows of another one are replaced. Makes the folder. Throws
  /// InputError if it cannot be written, or has other files.
  SolvedRows(std::filesystem::path folder, const std::string& key,
             const std::optional<Shard>& shard);

  /// Whether this process solves the row.
  [[nodiscard]] bool isOwn(int j) const { return !m_shard || m_shard->has(std::size_t(j)); }
  /// Returns a row's bytes; none if it is not there.
  [[nodiscard]] std::optional<std::string> read(int j) const;
  /// Writes a row, which is safe on disk once this returns. Throws InputError (full disk).
  void write(int j, const std::string& bytes) const;
  /// Deletes the rows in a folder, and the folder, after the result has been written.
  static void remove(const std::filesystem::path& folder);

 private:
  [[nodiscard]] std::filesystem::path fileOf(int j) const;

  std::filesystem::path m_folder;
  std::string m_head;
  std::optional<Shard> m_shard;
};

}  // namespace hogelscope
