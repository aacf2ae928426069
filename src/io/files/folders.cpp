// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/folders.h"

#include <algorithm>

#include "core/base/error.h"

namespace hogelscope {

namespace fs = std::filesystem;

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

namespace {

template <class Wanted>
std::vector<fs::path> entriesThat(const fs::path& folder, Wanted isWanted) {
  std::error_code error;
  std::vector<fs::path> entries;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (isWanted(*entry)) entries.push_back(entry->path());
  if (error) throw InputError(folder.string(), "cannot be read", error.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

}  // namespace

std::vector<fs::path> entriesOf(const fs::path& folder) {
  return entriesThat(folder, [](const fs::directory_entry&) { return true; });
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  return entriesThat(folder, [](const fs::directory_entry& entry) {
    std::error_code unknown;
    return !entry.is_directory(unknown);
  });
}

}  // namespace hogelscope
