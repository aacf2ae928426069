// SPDX-License-Identifier: BSD-3-Clause
// Output of batch mode: notes on stderr, what long runs say, and a progress bar on a terminal.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/base/shard.h"

namespace hogelscope {

/// Prints "hogelscope: TEXT" as one line on stderr.
void printNote(const std::string& text);

/// Prints what a long run found in its folder: the journal of another `run`, which it replaced, and
/// finished rows of its own.
void printFound(const std::filesystem::path& folder, bool replacedAnother, std::size_t taken,
                const std::string& rows, const std::string& run = "run");

/// Prints on stdout that the rows of a shard are done, and what the run without a shard will write.
/// Returns false if there is no shard.
bool printShard(const std::optional<Shard>& shard, const std::string& rows,
                const std::string& result);

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
