// SPDX-License-Identifier: BSD-3-Clause
#include "campaign/rows.h"

#include "core/base/error.h"

namespace hogelscope {

CampaignRows::CampaignRows(const std::filesystem::path& folder, const JournalHead& head,
                           const std::optional<Shard>& shard, std::size_t values)
    : m_journal(folder, head, shard), m_has(head.states * head.tests) {
  take(m_journal.entries(), values);
  if (shard) return;
  for (const FoundJournal& found : findJournals(folder)) {
    if (!found.shard || found.head.key != head.key) continue;
    if (found.isInUse)
      throw InputError(found.file.string(), "is in use",
                       "shard " + textOf(*found.shard) + " of this report is still at work; wait");
    take(found.entries, values);
    m_shards.push_back(*found.shard);
    m_shardFiles.push_back(found.file);
  }
}

void CampaignRows::take(const JournalEntries& entries, std::size_t values) {
  for (const auto& [row, entry] : entries)
    if (row < m_has.size() && m_has[row] == 0 && entry.values.size() == values) {
      m_has[row] = 1;
      m_taken[row] = entry;
    }
}

void CampaignRows::remove() {
  m_journal.remove();
  std::error_code ignored;
  for (const std::filesystem::path& file : m_shardFiles) std::filesystem::remove(file, ignored);
}

}  // namespace hogelscope
