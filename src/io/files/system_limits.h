// SPDX-License-Identifier: BSD-3-Clause
// Resources of this machine, and the program's share of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace hogelscope {

/// Returns the bytes of memory that the process may have: the least of the machine's, of those of
/// its control groups (a container, a job of Slurm) and of its limit of addresses, when it began.
std::size_t machineMemory();

/// Returns the bytes for light fields: those of allowMemory(), or a quarter of the memory.
std::size_t allowedMemory() noexcept;
/// Sets that number for the whole process.
void allowMemory(std::size_t bytes) noexcept;

/// Throws InputError that names the file if `bytes` exceed what is `allowed`; `advice` tells the
/// user what to do.
void checkFits(double bytes, const std::filesystem::path& file,
               const std::string& advice = "allow more", std::size_t allowed = allowedMemory());

/// Returns the limit of the control groups that `groups`, a text such as that of /proc/self/cgroup,
/// names below `root`; none if they have no limit. Of both versions of control groups.
std::optional<std::size_t> memoryOfGroups(const std::string& groups,
                                          const std::filesystem::path& root);

/// Throws InputError if the disk has fewer than `needed` bytes free for a file; call it before long
/// work. `mine` is the number of bytes of the file that exist already.
void checkRoomOnDisk(const std::filesystem::path& file, std::uint64_t needed,
                     std::uint64_t mine = 0);

}  // namespace hogelscope
