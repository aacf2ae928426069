// SPDX-License-Identifier: BSD-3-Clause
// A progress bar with the time left on a terminal.
#pragma once

#include <chrono>
#include <string>

#include "core/base/progress.h"

namespace hogelscope {

class ProgressBar {
 public:
  /// Draws only where stderr is a terminal and not `quiet`.
  ProgressBar(std::string what, bool quiet);

  /// Draws, and says stop after Ctrl-C or SIGTERM. For threads.
  [[nodiscard]] Progress progress();
  /// Wipes the bar.
  void done();

 private:
  void draw(double fraction);

  std::string m_what;
  bool m_isShown;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
  std::string m_line;
};

}  // namespace hogelscope
