// SPDX-License-Identifier: BSD-3-Clause
#include "cli/program.h"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/stop_signals.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "io/files/files_in_use.h"
#include "io/files/system_limits.h"
#include "io/files/temporary_files.h"
#include "io/plugins/plugin_list.h"

namespace hogelscope {

namespace {

enum ExitStatus { badInput = 2, internalError = 3 };

/// While it lives, a plugin or a library that calls exit() does not look like the job's end.
class UnfinishedJob {
 public:
  UnfinishedJob() {
    std::atexit([] {
      if (!isUnfinished) return;
      removeTemporaries();
      printNote("internal error: a plugin or a library ended the program before the job's end");
      std::_Exit(internalError);
    });
    isUnfinished = true;
  }
  UnfinishedJob(const UnfinishedJob&) = delete;
  UnfinishedJob& operator=(const UnfinishedJob&) = delete;
  ~UnfinishedJob() { isUnfinished = false; }

 private:
  static inline std::atomic<bool> isUnfinished = false;
};

}  // namespace

int runProgram(int argc, char** argv, const std::function<int(const CommandLine&)>& run) {
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding the file size limit becomes an error of write()
  try {
    const CommandLine line = parseCommandLine({argv + 1, argv + argc});
    if (line.mayHave("memory") && line.has("memory"))
      allowMemory(std::size_t(1e6 * *line.number("memory")));
    return run(line);
  } catch (const InputError& error) {
    printNote(error.what());
    return badInput;
  } catch (const std::filesystem::filesystem_error& error) {
    printNote(error.path1().string() + ": cannot be used: " + error.code().message());
    return badInput;
  } catch (const std::system_error& error) {
    printNote("threads: cannot be started: " + error.code().message() + "; allow this user more");
    return badInput;
  } catch (const Cancelled&) {
    endBySignal();
  } catch (const std::bad_alloc&) {
    printNote("memory: not enough for this light field and these pictures");
    return badInput;
  } catch (const std::exception& error) {
    printNote(std::string("internal error: ") + error.what());
    return internalError;
  }
}

void usePluginFolders(const CommandLine& line) {
  if (!line.mayHave("plugins-path")) return;
  for (const std::string& folder : line.texts("plugins-path")) addPluginFolder(folder);
}

int runBatch(const CommandLine& line) {
  const UnfinishedJob unfinished;
  if (line.mayHave("threads")) setThreads(int(line.number("threads").value_or(0)));
  usePluginFolders(line);
  try {
    const FilesInUse inUse(namedInputs(line));
    return line.job->run(line);
  } catch (const InputError& error) {
    const bool isOfOption = std::string_view(error.what()).starts_with("--");
    if (isOfOption || !line.mayHave("session") || !line.has("session")) throw;
    throw error.in(line.text("session"));
  }
}

}  // namespace hogelscope
