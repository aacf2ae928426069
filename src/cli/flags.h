// SPDX-License-Identifier: BSD-3-Clause
// The options of the command line, beside those that choose the job: the one table that parsing,
// refusals and --help read.
#pragma once

#include <limits>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"

namespace hogelscope {

struct NumberRange {
  double min = 0;
  double max = std::numeric_limits<double>::infinity();
  bool isInteger = false;
};

struct Flag {
  std::string_view name;
  std::string_view value = {};                 ///< "" if none follows
  std::vector<Command> jobs;                   ///< those that use it; all others refuse it
  std::vector<Command> neededBy = {};          ///< those that cannot do without it
  std::string_view unless = {};                ///< an option that makes up for a missing one
  bool mayRepeat = false;                      ///< with another value each time
  std::optional<NumberRange> range = {};       ///< of the value, where it must be a number
  std::vector<std::string_view> choices = {};  ///< the allowed values; any if empty
  /// The parameter that the flag sets, as --set does, in the job that the parameter belongs to.
  std::string_view shortFor = {};
  std::string_view help;
};

/// Flags under one heading of --help.
struct FlagGroup {
  std::string_view heading;
  std::vector<Flag> flags;
};

const std::vector<FlagGroup>& flagGroups();

inline auto allFlags() {
  return flagGroups() | std::views::transform(&FlagGroup::flags) | std::views::join;
}

/// Throws InputError.
void checkValue(const Flag& flag, const std::string& value);

}  // namespace hogelscope
