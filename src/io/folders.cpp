// SPDX-License-Identifier: BSD-3-Clause
// Looking at files and folders without exceptions other than ours.
#include "io/folders.h"

#include <sys/stat.h>

#include <algorithm>
#include <map>

#include "core/error.h"

namespace hogelscope {

namespace fs = std::filesystem;

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    entries.push_back(entry->path());
  if (error) throw InputError(folder.string(), "cannot be read", error.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

void checkOutputs(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  std::map<std::pair<dev_t, ino_t>, const fs::path*> read;
  struct stat status {};
  for (const fs::path& input : inputs)
    if (!input.empty() && ::stat(input.c_str(), &status) == 0)
      read[{status.st_dev, status.st_ino}] = &input;
  for (const fs::path& output : outputs) {
    if (::stat(output.c_str(), &status) != 0) continue;
    const auto found = read.find({status.st_dev, status.st_ino});
    if (found != read.end())
      throw InputError(
          output.string(), "cannot be written",
          "it is " + found->second->string() + ", which is read: give another --output");
  }
}

}  // namespace hogelscope
