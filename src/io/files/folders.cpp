// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/folders.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include "core/base/error.h"
#include "io/files/atomic_file.h"

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

namespace fs = std::filesystem;

namespace {

/// Returns 0, or errno.
int errorOfWriting(const fs::path& folder) {
  int file = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  if (file < 0) {  // the file system may not support unnamed files
    std::string name = (folder / ".hogelscope-XXXXXX").string();
    file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file >= 0) ::unlink(name.c_str());
  }
  if (file < 0) return errno;
  const int error = ::write(file, "x", 1) == 1 ? 0 : errno;
  ::close(file);
  return error;
}

}  // namespace

std::string besideDocument(const fs::path& folder, const std::string& file) {
  std::error_code error;
  const fs::path joined = folder / file;
  fs::path shorter = joined.lexically_normal();
  if (!shorter.has_filename()) shorter = shorter.parent_path();  // "views/" is "views"
  // ".." after a link leads to another folder than its text.
  const bool isSame = !fs::exists(joined, error) || fs::equivalent(joined, shorter, error);
  return isSame ? shorter.string() : joined.string();
}

std::string relativeTo(const fs::path& document, const std::string& file) {
  if (file.empty()) return {};
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(document, error).parent_path(), error);
  const fs::path target = fs::weakly_canonical(fs::absolute(file, error), error);
  const fs::path relative = target.lexically_relative(folder);
  return relative.empty() ? target.string() : relative.string();
}

void checkWritable(const fs::path& folder) {
  if (const int error = errorOfWriting(folder); error != 0)
    throw InputError(folder.string(), "cannot be written", std::strerror(error));
}

void makeFolderOf(const fs::path& file) {
  const fs::path folder = file.parent_path();
  makeFolder(folder.empty() ? fs::path(".") : folder);
}

}  // namespace hogelscope
