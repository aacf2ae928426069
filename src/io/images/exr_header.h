// SPDX-License-Identifier: BSD-3-Clause
// Checks an EXR's header before OpenEXR reads it.
#pragma once

#include <filesystem>

namespace hogelscope {

/// OpenEXR allocates what a header declares before it knows that the file has it: 1.3 kB can ask
/// for gigabytes. Throws InputError if an attribute, or the table of chunks, would be longer than
/// the file. Any other file is accepted.
void checkExrHeader(const std::filesystem::path& file);

}  // namespace hogelscope
