// SPDX-License-Identifier: BSD-3-Clause
// Whether results can be written, and over nothing that is read: known before the work begins.
#pragma once

#include <filesystem>
#include <vector>

namespace hogelscope {

/// Throws InputError where no file can be written into the folder: permissions, a read-only or a
/// full disk. Leaves nothing behind.
void checkWritable(const std::filesystem::path& folder);

/// Makes the folder that the file will be in, and those above it; throws InputError as
/// checkWritable() does.
void makeFolderOf(const std::filesystem::path& file);

/// Throws InputError where one of the files to write is one of those to read, by whatever name or
/// link: to be asked before any work. Missing files are no reason.
void checkOutputs(const std::vector<std::filesystem::path>& outputs,
                  const std::vector<std::filesystem::path>& inputs);

}  // namespace hogelscope
