// SPDX-License-Identifier: BSD-3-Clause
// The scenes of a campaign whose reports are finished, so that the same command goes on with the
// next one after a stop: a line "KEY NAME" for each in OUTPUT/campaign.journal.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace hogelscope {

class CampaignJournal {
 public:
  /// Reads the journal in a folder, if there is one. Throws InputError if the file is none.
  explicit CampaignJournal(const std::filesystem::path& folder);

  /// Whether a scene's report with this key (ReportFacts::key) is finished.
  [[nodiscard]] bool has(const std::string& scene, const std::string& key) const;
  /// Returns the keys of the finished scenes, by name.
  [[nodiscard]] const std::map<std::string, std::string>& scenes() const { return m_keys; }
  /// Writes the journal, so that the folder is known as a campaign's. Throws InputError.
  void begin() const;
  /// Adds a finished scene; it is on disk once this returns. Throws InputError (full disk).
  void add(const std::string& scene, const std::string& key);
  /// Deletes the journal, after the campaign's files have been written.
  void remove();

  static std::filesystem::path fileIn(const std::filesystem::path& folder) {
    return folder / "campaign.journal";
  }

 private:
  std::filesystem::path m_file;
  std::map<std::string, std::string> m_keys;
};

}  // namespace hogelscope
