// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/system_limits.h"

#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <sstream>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::atomic<std::size_t> theAllowedMemory = 0;

}  // namespace

std::optional<std::size_t> memoryOfGroups(const std::string& groups, const fs::path& root) {
  std::optional<std::size_t> least;
  std::istringstream lines(groups);
  for (std::string line; std::getline(lines, line);) {
    // HIERARCHY:CONTROLLERS:PATH; version 2 has no controllers here.
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == line.npos || second == line.npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    if (!controllers.empty() && controllers != "memory") continue;
    const fs::path top = controllers.empty() ? root : root / "memory";
    const char* const name = controllers.empty() ? "memory.max" : "memory.limit_in_bytes";
    // The limits of all groups around it count, too. In a container they may be above its root.
    fs::path group = fs::path(line.substr(second + 1)).relative_path();
    for (;; group = group.parent_path()) {
      std::size_t limit = 0;
      if (std::ifstream(top / group / name) >> limit)
        least = std::min(limit, least.value_or(limit));
      if (group.empty()) break;
    }
  }
  return least;
}

std::size_t machineMemory() {
  static const std::size_t memory = [] {
    std::size_t least =
        std::size_t(::sysconf(_SC_PHYS_PAGES)) * std::size_t(::sysconf(_SC_PAGESIZE));
    std::ifstream file("/proc/self/cgroup");
    const std::string groups{std::istreambuf_iterator<char>(file), {}};
    least = std::min(least, memoryOfGroups(groups, "/sys/fs/cgroup").value_or(least));
    struct rlimit limit {};
    if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      least = std::min(least, std::size_t(limit.rlim_cur));
    return least;
  }();
  return memory;
}

void checkFits(double bytes, const fs::path& file, const std::string& advice, std::size_t allowed) {
  if (bytes > double(allowed))
    throw InputError(file.string(), "size",
                     "needs " + bytesText(std::size_t(std::min(bytes, 1e18))) + " of memory, " +
                         bytesText(allowed) + " are allowed: " + advice);
}

std::size_t allowedMemory() noexcept {
  const std::size_t allowed = theAllowedMemory;
  return allowed > 0 ? allowed : machineMemory() / 4;
}

void allowMemory(std::size_t bytes) noexcept {
  theAllowedMemory = bytes;
}

void checkRoomOnDisk(const fs::path& file, std::uint64_t needed, std::uint64_t mine) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  struct statvfs disk {};
  if (::statvfs(folder.c_str(), &disk) != 0) return;  // reported when writing
  const double room = double(disk.f_bavail) * double(disk.f_frsize) + double(mine);
  if (room < double(needed))
    throw InputError(file.string(), "cannot be written",
                     "it needs about " + bytesText(needed) + ", the disk has " +
                         bytesText(std::size_t(room)) + " left");
}

}  // namespace hogelscope
