// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/system_limits.h"

#include <sys/statvfs.h>
#include <unistd.h>

#include <atomic>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::atomic<std::size_t> theAllowedMemory = 0;

}  // namespace

std::size_t machineMemory() {
  return std::size_t(::sysconf(_SC_PHYS_PAGES)) * std::size_t(::sysconf(_SC_PAGESIZE));
}

void checkFits(std::size_t bytes, const fs::path& file, const std::string& hint) {
  if (double(bytes) > 0.9 * double(machineMemory()))
    throw InputError(file.string(), "size",
                     "needs " + bytesText(bytes) + " of memory, this machine has " +
                         bytesText(machineMemory()) + hint);
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
