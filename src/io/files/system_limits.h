// SPDX-License-Identifier: BSD-3-Clause
// What this machine has, and how much of it we may use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace hogelscope {

/// Bytes.
std::size_t machineMemory();
/// Throws InputError that names the file where `bytes` are more than this machine's memory; `hint`
/// says what to do then.
void checkFits(std::size_t bytes, const std::filesystem::path& file, const std::string& hint);

/// Bytes for light fields: what allowMemory() said, or a quarter of this machine's.
std::size_t allowedMemory() noexcept;
/// From now on, in the whole process.
void allowMemory(std::size_t bytes) noexcept;

/// Before long work: throws InputError where the disk has less room left than `needed` bytes for a
/// file. `mine`: bytes that are there already and will be used.
void checkRoomOnDisk(const std::filesystem::path& file, std::uint64_t needed,
                     std::uint64_t mine = 0);

}  // namespace hogelscope
