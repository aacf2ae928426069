// SPDX-License-Identifier: BSD-3-Clause
// The file of keys that a user gave to commands: {"hogelscopeKeys": 1, "keys": {"NAME": "Ctrl+D"}}.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace hogelscope {

/// Keys by the name of the command, as texts; "" is a command without a key.
using KeyTexts = std::map<std::string, std::string>;

/// Throws InputError: cannot be read, not such a file.
KeyTexts loadKeyTexts(const std::filesystem::path& file);

/// Makes the folder too. Throws InputError.
void saveKeyTexts(const std::filesystem::path& file, const KeyTexts& keys);

}  // namespace hogelscope
