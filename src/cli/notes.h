// SPDX-License-Identifier: BSD-3-Clause
// What batch mode says beside its output.
#pragma once

#include <string>

namespace hogelscope {

/// Prints "hogelscope: TEXT" as one line on stderr.
void printNote(const std::string& text);

}  // namespace hogelscope
