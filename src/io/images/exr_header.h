// SPDX-License-Identifier: BSD-3-Clause
// Checks an EXR's header before OpenEXR reads it.
#pragma once

#include <filesystem>

namespace hogelscope {

/// Throws InputError if an attribute, or the table of chunks, would be longer than the file.
/// OpenEXR allocates what a header declares before it checks the file's size: 1.3 kB can request
/// gigabytes. Any other file is accepted.
void checkExrHeader(const std::filesystem::path& file);

}  // namespace hogelscope
