// SPDX-License-Identifier: BSD-3-Clause
// The file of the keys that a user has assigned: {"hogelscopeKeys": 1, "keys": {"NAME": "Ctrl+D"}}.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace hogelscope {

/// Key sequences by the name of the command; "" for a command without a key.
using KeyTexts = std::map<std::string, std::string>;

/// Reads the file. Throws InputError if it cannot be read or is not such a file.
KeyTexts loadKeyTexts(const std::filesystem::path& file);

/// Writes the file, and creates its folder. Throws InputError.
void saveKeyTexts(const std::filesystem::path& file, const KeyTexts& keys);

}  // namespace hogelscope
