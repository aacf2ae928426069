// SPDX-License-Identifier: BSD-3-Clause
// The jobs of the command line. A new job is a row of this table, and is named by its flags
// (flags.cpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"

namespace hogelscope {

struct Job {
  Command command;
  std::string_view name;        ///< of the option that selects it
  std::string_view value = {};  ///< "" if the option has no value
  std::string help;
  std::string details = {};                     ///< shown by --help JOB only
  std::string_view examples = {};               ///< command lines
  std::vector<std::string_view> sections = {};  ///< known to --set for this job only
  int (*run)(const CommandLine& line);          ///< returns the exit status
};

const std::vector<Job>& jobs();

/// Returns the job of a command, which must not be Command::window: it has no option.
const Job& jobOf(Command command);

bool isOneOf(const std::vector<Command>& commands, Command command);

/// Whether an option's value, as --help shows it ("uniform|random|normal|FILE"), may name a file.
bool mayNameFile(std::string_view value);

/// Returns a list such as "--render, --report", without the window.
std::string optionsOf(const std::vector<Command>& commands);

}  // namespace hogelscope
