// SPDX-License-Identifier: BSD-3-Clause
// Whether results can be written, known before the work for them begins.
#pragma once

#include <filesystem>

namespace hogelscope {

/// Throws InputError where no file can be written into the folder: permissions, a read-only or a
/// full disk. Leaves nothing behind.
void checkWritable(const std::filesystem::path& folder);

/// Makes the folder that the file will be in, and those above it; throws InputError as
/// checkWritable() does.
void makeFolderOf(const std::filesystem::path& file);

}  // namespace hogelscope
