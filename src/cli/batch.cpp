// SPDX-License-Identifier: BSD-3-Clause
#include "cli/batch.h"

#include "cli/jobs.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "io/plugins/plugin_folders.h"

namespace hogelscope {

void usePluginFolders(const CommandLine& line) {
  if (!line.mayHave("plugins-path")) return;
  for (const std::string& folder : line.texts("plugins-path")) addPluginFolder(folder);
}

int runBatch(const CommandLine& line) {
  if (line.mayHave("threads")) setThreads(int(line.number("threads").value_or(0)));
  usePluginFolders(line);
  try {
    return jobOf(line.command).run(line);
  } catch (const InputError& error) {
    const bool isOfOption = std::string_view(error.what()).starts_with("--");
    if (isOfOption || !line.mayHave("session") || !line.has("session")) throw;
    throw error.in(line.text("session"));
  }
}

}  // namespace hogelscope
