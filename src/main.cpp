// SPDX-License-Identifier: BSD-3-Clause
// The program hogelscope: batch mode where the command line asks for a job, else it becomes
// hogelscope-window. So jobs load neither VTK nor Qt's widgets.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>

#include "cli/program.h"
#include "cli/stop_signals.h"
#include "core/base/error.h"

namespace {

namespace fs = std::filesystem;

[[noreturn]] void becomeWindow(char** argv) {
  const fs::path window = fs::read_symlink("/proc/self/exe").parent_path() / "hogelscope-window";
  ::execv(window.c_str(), argv);
  if (errno == ENOENT)
    throw hogelscope::InputError(window.string(), "is not installed",
                                 "the package hogelscope-window has the window");
  throw hogelscope::InputError(window.string(), "cannot be started", std::strerror(errno));
}

int runJob(const hogelscope::CommandLine& line) {
  hogelscope::catchSignals();
  const int status = hogelscope::runBatch(line);
  if (!std::cout.flush()) throw hogelscope::InputError("standard output", "cannot be written");
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  return hogelscope::runProgram(argc, argv, [argv](const hogelscope::CommandLine& line) {
    if (line.job == nullptr) becomeWindow(argv);
    return runJob(line);
  });
}
