// SPDX-License-Identifier: BSD-3-Clause
// Output of batch mode on stderr: notes, and a progress bar on a terminal.
#pragma once

#include <chrono>
#include <string>

#include "core/base/progress.h"

namespace hogelscope {

/// Prints "hogelscope: TEXT" as one line on stderr.
void printNote(const std::string& text);

/// A progress bar with the remaining time.
class ProgressBar {
 public:
  /// Draws only if stderr is a terminal, unless `quiet`.
  ProgressBar(std::string what, bool quiet);

  /// Returns a thread-safe progress that draws, and cancels after SIGINT or SIGTERM.
  [[nodiscard]] Progress progress();
  /// Clears the bar.
  void done();

 private:
  void draw(double fraction);

  std::string m_what;
  bool m_isShown;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
  std::string m_line;
};

}  // namespace hogelscope
