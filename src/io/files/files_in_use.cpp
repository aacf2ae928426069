// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/files_in_use.h"

#include <sys/stat.h>

#include <map>
#include <mutex>
#include <optional>
#include <set>

#include "core/base/error.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

using Identity = std::pair<unsigned long, unsigned long>;

struct Marked {
  fs::path name;
  int count = 0;
};

struct MarkedFiles {
  std::mutex mutex;
  std::map<Identity, Marked> files;
};

MarkedFiles& markedFiles() {
  static MarkedFiles one;
  return one;
}

/// Returns the identity of a file, or of what a link leads to; none for what is not a file.
std::optional<Identity> identityOf(const fs::path& file) {
  struct stat status {};
  if (file.empty() || ::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
    return std::nullopt;
  return Identity{status.st_dev, status.st_ino};
}

}  // namespace

FilesInUse::FilesInUse(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    const auto identity = identityOf(file);
    if (!identity) continue;
    const std::lock_guard lock(markedFiles().mutex);
    Marked& marked = markedFiles().files[*identity];
    if (marked.count++ == 0) marked.name = file;
    m_marked.push_back(*identity);
  }
}

FilesInUse::~FilesInUse() {
  const std::lock_guard lock(markedFiles().mutex);
  for (const Identity& identity : m_marked)
    if (const auto found = markedFiles().files.find(identity); --found->second.count == 0)
      markedFiles().files.erase(found);
}

void checkOutputs(const std::vector<fs::path>& outputs) {
  std::set<fs::path> once;
  for (const fs::path& output : outputs) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(output, error);
    if (!once.insert(error ? output : whole).second)
      throw InputError(output.string(), "would be written twice", "choose other names");
    requireUnused(output);
  }
}

void requireUnused(const fs::path& output) {
  const auto identity = identityOf(output);
  const std::lock_guard lock(markedFiles().mutex);
  const auto found = identity ? markedFiles().files.find(*identity) : markedFiles().files.end();
  if (found != markedFiles().files.end())
    throw InputError(
        output.string(), "cannot be written",
        "it is " + found->second.name.string() + ", which is read: choose another name");
}

}  // namespace hogelscope
