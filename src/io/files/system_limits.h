// SPDX-License-Identifier: BSD-3-Clause
// Resources of this machine, and how much of them the program may use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace hogelscope {

/// Returns the bytes of this machine's memory.
std::size_t machineMemory();
/// Throws InputError that names the file if `bytes` are more than this machine's memory; `hint`
/// tells the user what to do.
void checkFits(std::size_t bytes, const std::filesystem::path& file, const std::string& hint);

/// Returns the bytes for light fields: those of allowMemory(), or a quarter of the memory.
std::size_t allowedMemory() noexcept;
/// Sets them from now on, for the whole process.
void allowMemory(std::size_t bytes) noexcept;

/// To be called before long work: throws InputError if the disk has less than `needed` bytes free
/// for a file. `mine` is the number of bytes of it that are there already.
void checkRoomOnDisk(const std::filesystem::path& file, std::uint64_t needed,
                     std::uint64_t mine = 0);

}  // namespace hogelscope
