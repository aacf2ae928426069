// SPDX-License-Identifier: BSD-3-Clause
// The jobs of the command line. A job is a row in a file of cli/jobs, beside its work; the list of
// those files in src/CMakeLists.txt is the order of the rows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "cli/flags.h"

namespace hogelscope {

struct Job {
  std::string_view name;        ///< of the option that selects it
  std::string_view value = {};  ///< "" if the option has no value
  bool mayRepeat = false;       ///< it may have several values, also as words behind it
  std::string help;
  std::string details = {};                     ///< shown by --help JOB only
  std::string_view examples = {};               ///< command lines
  std::vector<std::string_view> sections = {};  ///< known to --set for this job only
  std::vector<std::string_view> needs = {};     ///< options that it requires
  std::vector<std::string_view> takes = {};     ///< options of several jobs that it accepts
  std::vector<Flag> own = {};                   ///< options that no other job has
  bool mayReplaceSession = false;               ///< its output may be its --session
  /// Does the work, and returns the exit status. Throws InputError, and Cancelled if it has a
  /// progress bar.
  int (*run)(const CommandLine& line);
};

const std::vector<Job>& jobs();

/// Whether a job accepts an option; null is the window.
bool accepts(const Job* job, const Flag& flag);
/// Whether a job requires an option; the window, null, requires none.
bool needs(const Job* job, const Flag& flag);

/// Whether an option's value, as --help shows it ("uniform|random|normal|FILE"), may name a file.
bool mayNameFile(std::string_view value);

/// Returns the jobs that accept an option, without the window.
std::vector<const Job*> jobsOf(const Flag& flag);
/// Returns a list such as "--render, --report".
std::string optionsOf(const std::vector<const Job*>& owners);

}  // namespace hogelscope
