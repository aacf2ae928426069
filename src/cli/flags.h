// SPDX-License-Identifier: BSD-3-Clause
// The options of the command line, except those that choose the job. Parsing, checks and --help use
// this single table.
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
  std::string_view value = {};                 ///< "" if the option has no value
  std::vector<Command> jobs;                   ///< those that accept it; all others reject it
  std::vector<Command> neededBy = {};          ///< those that require it
  std::string_view unless = {};                ///< an option that replaces a missing one
  bool isInput = false;                        ///< its value is a file that the job reads
  bool mayRepeat = false;                      ///< with different values
  std::optional<NumberRange> range = {};       ///< of the value, if it must be a number
  std::vector<std::string_view> choices = {};  ///< the allowed values; any if empty
  /// The parameter that the flag sets, like --set, in the job that owns the parameter.
  std::string_view shortFor = {};
  std::string_view help;
};

/// Flags under a heading of --help.
struct FlagGroup {
  std::string_view heading;
  std::vector<Flag> flags;
};

const std::vector<FlagGroup>& flagGroups();

inline auto allFlags() {
  return flagGroups() | std::views::transform(&FlagGroup::flags) | std::views::join;
}

/// Checks a value of the flag. Throws InputError.
void checkValue(const Flag& flag, const std::string& value);

}  // namespace hogelscope
