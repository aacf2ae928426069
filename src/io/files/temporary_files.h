// SPDX-License-Identifier: BSD-3-Clause
// A list of temporary files, to remove them when the process ends early.
#pragma once

#include <filesystem>

namespace hogelscope {

/// Adds a file to the list, which the whole process shares. Thread-safe.
void registerTemporary(const std::filesystem::path& file);
void forgetTemporary(const std::filesystem::path& file);

/// Removes all files before the process ends. A thread that tries to register or forget a file
/// afterwards waits forever, so that no file is missed.
void removeTemporaries();

}  // namespace hogelscope
