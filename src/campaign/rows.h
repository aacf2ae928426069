// SPDX-License-Identifier: BSD-3-Clause
// The rows of a long run, stored on disk as they finish, so that a run can resume and several
// processes can share it.
#pragma once

#include <mutex>
#include <vector>

#include "campaign/journal.h"

namespace hogelscope {

class CampaignRows {
 public:
  /// Takes the rows of an earlier run in `folder` and, unless this is a shard, those of all shards.
  /// A row has `values` values. Throws InputError if a shard of this run is still running, or as
  /// Journal does.
  CampaignRows(const std::filesystem::path& folder, const JournalHead& head,
               const std::optional<Shard>& shard, std::size_t values);

  [[nodiscard]] bool has(std::size_t row) const { return m_has[row] != 0; }
  /// Returns the rows taken from earlier runs.
  [[nodiscard]] const JournalEntries& taken() const { return m_taken; }
  /// Returns the shards whose rows were taken.
  [[nodiscard]] const std::vector<Shard>& shards() const { return m_shards; }
  [[nodiscard]] bool replacedAnother() const { return m_journal.replacedAnother(); }

  /// Adds a row, then calls `added`; from any thread, one at a time. Throws InputError (full disk).
  template <class Action>
  void add(std::size_t row, const JournalEntry& entry, const Action& added) {
    const std::lock_guard lock(m_mutex);
    m_journal.add(row, entry.values, entry.problem);
    m_has[row] = 1;
    added();
  }
  /// Removes the journals after the run's results have been written.
  void remove();

 private:
  void take(const JournalEntries& entries, std::size_t values);

  Journal m_journal;
  JournalEntries m_taken;
  std::vector<Shard> m_shards;
  std::vector<std::filesystem::path> m_shardFiles;
  std::mutex m_mutex;
  std::vector<std::uint8_t> m_has;
};

}  // namespace hogelscope
