// SPDX-License-Identifier: BSD-3-Clause
// What a file holds, as a number that no other content has: SHA-256.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"

namespace hogelscope {

/// 64 hexadecimal digits. Of several files: of the lines "HASH  NAME\n" that sha256sum prints for
/// them in their folder. Throws InputError, Cancelled.
std::string sha256(const std::vector<std::filesystem::path>& files, const Progress& progress = {});
std::string sha256(const std::string& text);

}  // namespace hogelscope
