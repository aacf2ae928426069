// SPDX-License-Identifier: BSD-3-Clause
// What a report has finished, on disk as soon as it is, so that the same command can go on after
// Ctrl-C or kill -9: OUTPUT/report.journal, a line of JSON for each row.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/metrics/report_rows.h"
#include "io/files/random_access_file.h"

namespace hogelscope {

class ReportJournal {
 public:
  /// What figures a row has; who it is of, the session says.
  struct Entry {
    Metrics metrics;
    std::string problem;
  };

  /// Takes up the journal in `folder` if it has the same `key`, else begins a new one in its place.
  /// A line that was cut off is forgotten. Throws InputError: a file of that name is not a journal,
  /// another process uses it, or it cannot be written.
  ReportJournal(const std::filesystem::path& folder, const std::string& key);
  ReportJournal(const ReportJournal&) = delete;
  ReportJournal& operator=(const ReportJournal&) = delete;

  /// Of an earlier run, by the row's index.
  [[nodiscard]] const std::map<std::size_t, Entry>& entries() const { return m_entries; }
  /// Was there a journal with another key?
  [[nodiscard]] bool replacedAnother() const { return m_replacedAnother; }

  /// The row outlives the process once this returns. Throws InputError (full disk).
  void add(std::size_t row, const Metrics& metrics, const std::string& problem);
  /// The report is written: the journal is not needed any more.
  void remove();

 private:
  std::uintmax_t read(const std::string& head);

  std::filesystem::path m_file;
  Descriptor m_descriptor{-1};
  std::map<std::size_t, Entry> m_entries;
  bool m_replacedAnother = false;
};

}  // namespace hogelscope
