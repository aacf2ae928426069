// SPDX-License-Identifier: BSD-3-Clause
// What the two programs share: batch mode and the window.
#include "cli/program.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "cli/parser.h"
#include "cli/stop_signals.h"
#include "core/base/error.h"
#include "io/files/system_limits.h"

namespace hogelscope {

namespace {

enum ExitStatus { badInput = 2, internalError = 3 };

}  // namespace

int runProgram(int argc, char** argv, const std::function<int(const CommandLine&)>& run) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow any more is an error of write()
  try {
    const CommandLine line = parseCommandLine({argv + 1, argv + argc});
    if (line.mayHave("memory") && line.has("memory"))
      allowMemory(std::size_t(1e6 * *line.number("memory")));
    return run(line);
  } catch (const InputError& error) {
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
  } catch (const Cancelled&) {
    endBySignal();
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr,
                 "hogelscope: memory: not enough for this light field and these pictures\n");
    return badInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hogelscope: internal error: %s\n", error.what());
    return internalError;
  }
}

}  // namespace hogelscope
