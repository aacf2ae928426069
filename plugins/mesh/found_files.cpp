// SPDX-License-Identifier: BSD-3-Clause
#include "found_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include "mesh_reader.h"

namespace hogelscope::mesh {

namespace fs = std::filesystem;

namespace {

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::string lowered(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/// Returns the entry of a folder whose name differs at most in the case of its letters, the first
/// by name if there are several; "" if there is none.
fs::path entryLike(const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (fs::exists(folder / name, error)) return folder / name;
  fs::path found;
  const std::string wanted = lowered(name);
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (lowered(entry->path().filename().string()) == wanted &&
        (found.empty() || entry->path() < found))
      found = entry->path();
  return found;
}

/// Returns the file at a relative path, in any case of its letters; "" if there is none.
fs::path fileLike(const fs::path& folder, const fs::path& relative) {
  fs::path at = folder.empty() ? fs::path(".") : folder;
  for (const fs::path& part : relative) {
    if (part.empty() || part == ".") continue;
    at = part == ".." ? at / part : entryLike(at, part.string());
    if (at.empty()) return {};
  }
  return isFile(at) ? at : fs::path();
}

}  // namespace

FoundFile foundBesides(const std::string& file, const std::string& name) {
  const std::string own = besides(file, name);
  if (isFile(own)) return {own, true};
  std::string plain = name;
  if (plain.size() > 1 && plain.front() == '"' && plain.back() == '"')
    plain = plain.substr(1, plain.size() - 2);
  std::ranges::replace(plain, '\\', '/');
  const fs::path folder = fs::path(file).parent_path();
  fs::path rest(plain);
  const bool isAbsolute = rest.is_absolute() || (plain.size() > 1 && plain[1] == ':');
  if (rest.is_absolute() && isFile(rest)) return {rest, true};
  if (!isAbsolute)
    if (const fs::path found = fileLike(folder, rest); !found.empty()) return {found, true};
  rest = rest.relative_path();
  for (fs::path tail; rest.begin() != rest.end(); rest = tail) {
    tail.clear();
    for (auto part = std::next(rest.begin()); part != rest.end(); ++part) tail /= *part;
    if (tail.empty()) break;
    const bool isInside = std::ranges::find(tail, fs::path("..")) == tail.end();
    if (const fs::path found = isInside ? fileLike(folder, tail) : fs::path(); !found.empty())
      return {found, true, true};
  }
  return {own};
}

}  // namespace hogelscope::mesh
