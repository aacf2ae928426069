// SPDX-License-Identifier: BSD-3-Clause
// The man page, made from the tables of jobs and flags.
#pragma once

#include <string>

namespace hogelscope {

/// hogelscope(1) in the language of man(7): what --help man prints and the build installs.
std::string manPage();

}  // namespace hogelscope
