// SPDX-License-Identifier: BSD-3-Clause
// The finished rows of a report, written to disk at once, so that the same command can resume after
// Ctrl-C or kill -9 and several processes can share the work: a line of JSON for each row in
// OUTPUT/report.journal, or OUTPUT/report.journal.K-N of shard K/N.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/shard.h"
#include "io/files/random_access_file.h"

namespace hogelscope {

/// The identity of a journal's report.
struct JournalHead {
  std::string key;  ///< unique to the report
  std::size_t states = 0;
  std::size_t tests = 0;
  bool operator==(const JournalHead&) const = default;
};

/// The values of a row; its state and test follow from the session.
struct JournalEntry {
  std::vector<double> values;
  std::string problem;
};
using JournalEntries = std::map<std::size_t, JournalEntry>;  ///< by row index

/// Returns the ending of file names: "" for a whole run, ".K-N" for a shard.
std::string endingOf(const std::optional<Shard>& shard);
/// Returns the file of the journal of a run into `folder`.
std::filesystem::path journalIn(const std::filesystem::path& folder,
                                const std::optional<Shard>& shard = {});

class Journal {
 public:
  /// Resumes the journal in `folder` if it has the same head; otherwise replaces it by a new one. A
  /// truncated line is dropped. Throws InputError if a file of that name is not a journal, another
  /// process uses it, or it cannot be written.
  Journal(const std::filesystem::path& folder, const JournalHead& head,
          const std::optional<Shard>& shard = {});
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Returns the rows of an earlier run.
  [[nodiscard]] const JournalEntries& entries() const { return m_entries; }
  /// Whether there was a journal with another head.
  [[nodiscard]] bool replacedAnother() const { return m_replacedAnother; }

  /// Adds a row, which is safe on disk once this returns. Throws InputError (full disk).
  void add(std::size_t row, const std::vector<double>& values, const std::string& problem);
  /// Deletes the journal, after the report has been written.
  void remove();

 private:
  std::filesystem::path m_file;
  Descriptor m_descriptor{-1};
  JournalEntries m_entries;
  bool m_replacedAnother = false;
};

/// A journal left or being written by a process.
struct FoundJournal {
  std::filesystem::path file;
  std::optional<Shard> shard;  ///< none for a whole run
  JournalHead head;
  JournalEntries entries;
  bool isInUse = false;
};

/// Returns the journals in a folder: the whole run's first, then by shard. Throws InputError.
std::vector<FoundJournal> findJournals(const std::filesystem::path& folder);

/// The rows of a long run, stored on disk as they finish, so that a run can resume and several
/// processes can share it.
class RunRows {
 public:
  /// Takes the rows of an earlier run in `folder` and, unless this is a shard, those of all shards.
  /// A row has `values` values. Throws InputError if a shard of this run is still running, or as
  /// Journal does.
  RunRows(const std::filesystem::path& folder, const JournalHead& head,
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
