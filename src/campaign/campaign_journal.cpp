// SPDX-License-Identifier: BSD-3-Clause
#include "campaign/campaign_journal.h"

#include <sstream>

#include "core/base/error.h"
#include "io/files/atomic_file.h"

namespace hogelscope {

namespace {

constexpr const char* firstLine = "hogelscope campaign 1";

}  // namespace

CampaignJournal::CampaignJournal(const std::filesystem::path& folder) : m_file(fileIn(folder)) {
  std::error_code none;
  if (!std::filesystem::exists(m_file, none)) return;
  std::istringstream lines(readTextFile(m_file));
  std::string line;
  if (!std::getline(lines, line) || line != firstLine)
    throw InputError(m_file.string(), "is no journal of a campaign", "move it away");
  while (std::getline(lines, line))
    if (const std::size_t space = line.find(' '); space != std::string::npos)
      m_keys[line.substr(space + 1)] = line.substr(0, space);
}

bool CampaignJournal::has(const std::string& scene, const std::string& key) const {
  const auto found = m_keys.find(scene);
  return found != m_keys.end() && found->second == key;
}

void CampaignJournal::begin() const {
  std::string text = std::string(firstLine) + "\n";
  for (const auto& [name, key] : m_keys) text += key + " " + name + "\n";
  writeTextFile(m_file, text);
}

void CampaignJournal::add(const std::string& scene, const std::string& key) {
  m_keys[scene] = key;
  begin();
}

void CampaignJournal::remove() {
  std::error_code none;
  std::filesystem::remove(m_file, none);
}

}  // namespace hogelscope
