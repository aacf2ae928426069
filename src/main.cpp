// SPDX-License-Identifier: BSD-3-Clause
// The program: batch mode where the command line asks for a job, else the window. The one place
// where errors become a line and an exit status.
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "cli/batch.h"
#include "cli/parser.h"
#include "cli/stop_signals.h"
#include "core/base/error.h"
#include "gui/app/application.h"
#include "io/files/system_limits.h"

namespace {

enum ExitStatus { done = 0, gateFailed = 1, badInput = 2, internalError = 3 };

int run(int argc, char** argv) {
  const hogelscope::CommandLine line = hogelscope::parseCommandLine({argv + 1, argv + argc});
  if (line.mayHave("memory") && line.has("memory"))
    hogelscope::allowMemory(std::size_t(1e6 * *line.number("memory")));
  if (line.command == hogelscope::Command::window) {
    hogelscope::usePluginFolders(line);
    return hogelscope::runWindow(argc, argv, line.files);
  }
  hogelscope::catchSignals();
  const int status = hogelscope::runBatch(line);
  if (!std::cout.flush()) throw hogelscope::InputError("standard output", "cannot be written");
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow any more is an error of write()
  try {
    return run(argc, argv);
  } catch (const hogelscope::InputError& error) {
    std::fprintf(stderr, "hogelscope: %s\n", error.what());
    return badInput;
  } catch (const std::filesystem::filesystem_error& error) {
    std::fprintf(stderr, "hogelscope: %s: cannot be used: %s\n", error.path1().c_str(),
                 error.code().message().c_str());
    return badInput;
  } catch (const std::system_error& error) {
    std::fprintf(stderr, "hogelscope: threads: cannot be started: %s; allow this user more\n",
                 error.code().message().c_str());
    return badInput;
  } catch (const hogelscope::Cancelled&) {
    hogelscope::endBySignal();
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr,
                 "hogelscope: memory: not enough for this light field and these pictures\n");
    return badInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hogelscope: internal error: %s\n", error.what());
    return internalError;
  }
}
