// SPDX-License-Identifier: BSD-3-Clause
// The program hogelscope-window, which hogelscope becomes without a job.
#include "cli/jobs.h"
#include "cli/program.h"
#include "core/base/error.h"
#include "gui/app/application.h"

int main(int argc, char** argv) {
  return hogelscope::runProgram(argc, argv, [argc, argv](const hogelscope::CommandLine& line) {
    if (line.command != hogelscope::Command::window)
      throw hogelscope::InputError("--" + std::string(hogelscope::jobOf(line.command).name), "",
                                   "is a job of hogelscope, not of its window");
    hogelscope::usePluginFolders(line);
    return hogelscope::runWindow(argc, argv, line.files);
  });
}
