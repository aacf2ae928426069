// SPDX-License-Identifier: BSD-3-Clause
// Notes of batch mode on stderr.
#pragma once

#include <string>

namespace hogelscope {

/// Prints "hogelscope: TEXT" as one line on stderr.
void printNote(const std::string& text);

}  // namespace hogelscope
