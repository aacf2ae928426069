// SPDX-License-Identifier: BSD-3-Clause
// The rows of a long run, kept on the disk as they are finished, so that a run goes on after a stop
// and several processes share it.
#pragma once

#include <mutex>
#include <vector>

#include "campaign/journal.h"

namespace hogelscope {

class CampaignRows {
 public:
  /// Takes up the rows of an earlier run in `folder`, and, but for a shard, those of all shards. A
  /// row has `values` figures. Throws InputError: a shard of this run is still at work, or as
  /// Journal does.
  CampaignRows(const std::filesystem::path& folder, const JournalHead& head,
               const std::optional<Shard>& shard, std::size_t values);

  [[nodiscard]] bool has(std::size_t row) const { return m_has[row] != 0; }
  /// The rows that were taken up.
  [[nodiscard]] const JournalEntries& taken() const { return m_taken; }
  /// The shards whose rows were taken up.
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
  /// The run's results are written: removes the journals.
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
