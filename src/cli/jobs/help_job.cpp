// SPDX-License-Identifier: BSD-3-Clause
// --help and --version.
#include <iostream>

#include "cli/help.h"
#include "cli/jobs/all_jobs.h"
#include "core/base/version.h"

namespace hogelscope {

int runHelp(const CommandLine& line) {
  std::cout << helpText(line.subject);
  return 0;
}

int runVersion(const CommandLine& /*line*/) {
  std::cout << "hogelscope " << programVersion() << "\n";
  return 0;
}

}  // namespace hogelscope
