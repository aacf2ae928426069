// SPDX-License-Identifier: BSD-3-Clause
// The options of the command line, except those that choose the job: those that jobs share, and
// each job's own. Parsing, checks and --help use this single table.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hogelscope {

struct NumberRange {
  double min = 0;
  double max = std::numeric_limits<double>::infinity();
  bool isInteger = false;
};

struct Flag {
  std::string_view name;
  std::string_view value = {};    ///< "" if the option has no value
  std::string_view heading = {};  ///< of --help, if it begins with this option
  /// The option that a job's own one follows in --help; if it is not given, the one before it in
  /// the job's list.
  std::string_view after = {};
  std::vector<std::string_view> unless = {};   ///< options that replace a missing one
  bool isInput = false;                        ///< its value is a file that the job reads
  bool mayRepeat = false;                      ///< with different values
  bool isForWindow = false;                    ///< the window takes it too
  std::string_view with = {};                  ///< jobs that take this option take it, too
  std::string_view lastJob = {};               ///< stands last where its jobs are listed
  std::optional<NumberRange> range = {};       ///< of the value, if it must be a number
  std::vector<std::string_view> choices = {};  ///< the allowed values; any if empty
  /// The parameter that the flag sets, like --set, in the job that owns the parameter.
  std::string_view shortFor = {};
  std::string_view help;
};

/// Returns all options in the order of --help.
const std::vector<Flag>& allFlags();

/// Checks a value of the flag. Throws InputError.
void checkValue(const Flag& flag, const std::string& value);

}  // namespace hogelscope
