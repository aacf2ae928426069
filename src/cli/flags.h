// SPDX-License-Identifier: BSD-3-Clause
// The flags of the command line: the one table that parsing and --help read.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.h"

namespace hogelscope {

/// What follows it, and what it does to the options. A command is a flag too.
struct Flag {
  std::string_view name;
  std::string_view value;  ///< "" if none follows
  std::string_view help;
  std::function<void(Options&, const std::string&)> apply;
};

/// What is to be done: one of them.
const std::vector<Flag>& jobs();
const std::vector<Flag>& settings();

/// By its name without dashes. Throws InputError, with the nearest name.
const Flag& findFlag(const std::string& name);

}  // namespace hogelscope
