// SPDX-License-Identifier: BSD-3-Clause
// The jobs of the command line: a new one is a row of this table, and named by the flags that it
// uses (flags.cpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"

namespace hogelscope {

struct Job {
  Command command;
  std::string_view name;        ///< of the option that asks for it
  std::string_view value = {};  ///< "" if none follows
  std::string help;
  std::string details = {};                     ///< which --help JOB alone has
  std::string_view examples = {};               ///< command lines
  std::vector<std::string_view> sections = {};  ///< that --set knows for this job alone
  int (*run)(const CommandLine& line);          ///< returns the exit status
};

const std::vector<Job>& jobs();

/// Not for Command::window, which has no option of its own.
const Job& jobOf(Command command);

bool isOneOf(const std::vector<Command>& commands, Command command);

/// "--render, --report"; without the window.
std::string optionsOf(const std::vector<Command>& commands);

}  // namespace hogelscope
