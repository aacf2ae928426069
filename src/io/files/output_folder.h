// SPDX-License-Identifier: BSD-3-Clause
// Checks before the work begins that results can be written, and replace no input.
#pragma once

#include <filesystem>
#include <vector>

namespace hogelscope {

/// Throws InputError if no file can be written into the folder: permissions, a read-only or a full
/// disk. Leaves nothing behind.
void checkWritable(const std::filesystem::path& folder);

/// Creates the folder of the file, and its parents; throws InputError as
/// checkWritable() does.
void makeFolderOf(const std::filesystem::path& file);

/// Throws InputError if one of the files to write is one of those to read, by whatever name or
/// link. To be called before any work. Missing files are ignored.
void checkOutputs(const std::vector<std::filesystem::path>& outputs,
                  const std::vector<std::filesystem::path>& inputs);

}  // namespace hogelscope
