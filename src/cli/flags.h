// SPDX-License-Identifier: BSD-3-Clause
// The options of the command line, beside those that choose the job: the one table that parsing,
// refusals and --help read.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.h"

namespace hogelscope {

struct Flag {
  std::string_view name;
  std::string_view value = {};         ///< "" if none follows
  std::vector<Command> jobs;           ///< those that use it; all others refuse it
  std::vector<Command> neededBy = {};  ///< those that cannot do without it
  bool mayRepeat = false;              ///< with another value each time
  std::string_view help;
  std::function<void(Options&, const std::string&)> apply;
};

/// Under one heading of --help.
struct FlagGroup {
  std::string_view heading;
  std::vector<Flag> flags;
};

const std::vector<FlagGroup>& flagGroups();

}  // namespace hogelscope
