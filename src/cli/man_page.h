// SPDX-License-Identifier: BSD-3-Clause
// The man page, generated from the tables of jobs and flags.
#pragma once

#include <string>

namespace hogelscope {

/// Returns hogelscope(1) in man(7), which --help man prints and the build installs.
std::string manPage();

}  // namespace hogelscope
