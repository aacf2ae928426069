// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/test_names.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

namespace hogelscope {

namespace {

using Parts = std::vector<std::string>;

/// Returns folders and name.
Parts partsOf(const std::string& file) {
  Parts parts;
  for (const std::filesystem::path& part : std::filesystem::path(file))
    if (!part.empty() && part != "/") parts.push_back(part.string());
  return parts;
}

/// Returns the last parts of a path, in short form.
std::string tailOf(const Parts& path, std::size_t count) {
  const std::string& first = path[path.size() - count];
  if (count == 1) return first;
  return first + (count == 2 ? "/" : "/…/") + path.back();
}

}  // namespace

std::vector<std::string> shortNames(const std::vector<std::string>& files) {
  std::vector<Parts> paths;
  paths.reserve(files.size());
  for (const std::string& file : files) paths.push_back(partsOf(file));
  std::vector<std::string> names;
  for (const Parts& path : paths) {
    std::size_t count = 1;
    const auto isShared = [&](const Parts& other) {
      const auto tail = std::min(other.size(), count);
      return other != path && std::equal(other.end() - std::ptrdiff_t(tail), other.end(),
                                         path.end() - std::ptrdiff_t(count), path.end());
    };
    while (count < path.size() && std::ranges::any_of(paths, isShared)) ++count;
    names.push_back(path.empty() ? "" : tailOf(path, count));
  }
  return names;
}

std::vector<std::string> figureNames(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const std::string& file : files) {
    std::string name = shortNames({file}).front();
    const std::size_t dot = name.rfind('.');
    const bool hasEnding = dot != std::string::npos && dot > 0 && dot + 1 < name.size() &&
                           std::isalpha(static_cast<unsigned char>(name[dot + 1])) != 0;
    names.push_back(hasEnding ? name.substr(0, dot) : name);  // not of q0.25
  }
  const std::set<std::string> different(names.begin(), names.end());
  return different.size() == files.size() && !different.contains("") ? names : shortNames(files);
}

std::string plotNameOf(const std::string& file, std::size_t test) {
  constexpr std::size_t longest = 60;  // of 255 bytes of a file's name
  std::string name = figureNames({file}).front().substr(0, longest);
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '-' && letter != '.')
      letter = '_';
  return "test" + std::to_string(test + 1) + (name.empty() ? "" : "_") + name;
}

}  // namespace hogelscope
