// SPDX-License-Identifier: BSD-3-Clause
#include "cli/notes.h"

#include <iostream>

#include "core/base/text.h"

namespace hogelscope {

void printNote(const std::string& text) {
  std::cerr << "hogelscope: " + printable(text) + "\n";
}

}  // namespace hogelscope
