// SPDX-License-Identifier: BSD-3-Clause
// The finished rows of a report, written to the disk at once, so that the same command can resume
// after Ctrl-C or kill -9: OUTPUT/report.journal, a line of JSON for each row.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/files/random_access_file.h"

namespace hogelscope {

class ReportJournal {
 public:
  /// The figures of a row; its state and test follow from the session.
  struct Entry {
    std::vector<double> values;
    std::string problem;
  };

  /// Resumes the journal in `folder` if it has the same `key`, else replaces it by a new one. A
  /// line that was cut off is dropped. Throws InputError: a file of that name is not a journal,
  /// another process uses it, or it cannot be written.
  ReportJournal(const std::filesystem::path& folder, const std::string& key);
  ReportJournal(const ReportJournal&) = delete;
  ReportJournal& operator=(const ReportJournal&) = delete;

  /// Returns the rows of an earlier run by their indices.
  [[nodiscard]] const std::map<std::size_t, Entry>& entries() const { return m_entries; }
  /// Whether there was a journal with another key.
  [[nodiscard]] bool replacedAnother() const { return m_replacedAnother; }

  /// Adds a row, which outlives the process once this returns. Throws InputError (full disk).
  void add(std::size_t row, const std::vector<double>& values, const std::string& problem);
  /// Deletes the journal, after the report has been written.
  void remove();

 private:
  std::uintmax_t read(const std::string& head);

  std::filesystem::path m_file;
  Descriptor m_descriptor{-1};
  std::map<std::size_t, Entry> m_entries;
  bool m_replacedAnother = false;
};

}  // namespace hogelscope
