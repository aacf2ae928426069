// SPDX-License-Identifier: BSD-3-Clause
// Resources of this machine, and the program's share of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace hogelscope {

/// Returns the size of this machine's memory in bytes.
std::size_t machineMemory();
/// Throws InputError that names the file if `bytes` exceed this machine's memory; `hint` is the
/// advice to the user.
void checkFits(std::size_t bytes, const std::filesystem::path& file, const std::string& hint);

/// Returns the bytes for light fields: those of allowMemory(), or a quarter of the memory.
std::size_t allowedMemory() noexcept;
/// Sets that number for the whole process.
void allowMemory(std::size_t bytes) noexcept;

/// Throws InputError if the disk has fewer than `needed` bytes free for a file; call it before long
/// work. `mine` is the number of bytes of the file that exist already.
void checkRoomOnDisk(const std::filesystem::path& file, std::uint64_t needed,
                     std::uint64_t mine = 0);

}  // namespace hogelscope
