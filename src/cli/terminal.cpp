// SPDX-License-Identifier: BSD-3-Clause
#include "cli/terminal.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>

#include "cli/stop_signals.h"
#include "core/base/text.h"
#include "runs/journal.h"

namespace hogelscope {

void printNote(const std::string& text) {
  std::cerr << "hogelscope: " + printable(text) + "\n";
}

void printFound(const std::filesystem::path& folder, bool replacedAnother, std::size_t taken,
                const std::string& rows, const std::string& run) {
  if (replacedAnother)
    printNote(journalIn(folder).string() + ": was of another " + run +
              " that did not finish; begun anew");
  if (taken > 0)
    printNote("went on after " + std::to_string(taken) + " " + rows + " of an earlier run");
}

bool printShard(const std::optional<Shard>& shard, const std::string& rows,
                const std::string& result) {
  if (shard)
    std::cout << "shard " << textOf(*shard) << ": its " << rows
              << " are done; the command without --shard writes the " << result << "\n";
  return shard.has_value();
}

ProgressBar::ProgressBar(std::string what, bool quiet)
    : m_what(std::move(what)), m_isShown(!quiet && ::isatty(STDERR_FILENO) == 1) {}

Progress ProgressBar::progress() {
  return forThreads([this](double fraction) {
    draw(fraction);
    return !mustStop();
  });
}

void ProgressBar::draw(double fraction) {
  if (!m_isShown) return;
  const auto elapsed = std::chrono::steady_clock::now() - m_start;
  const int percent = static_cast<int>(100 * fraction);
  constexpr int width = 40;
  const auto filled = static_cast<std::size_t>(width * percent / 100);
  const std::string line = m_what + " [" + std::string(filled, '#') +
                           std::string(width - filled, ' ') + "] " + std::to_string(percent) +
                           " % " +
                           timeLeft(std::chrono::duration<double>(elapsed).count(), fraction);
  if (line == m_line) return;
  m_line = line;
  std::fprintf(stderr, "\r%s\033[K", line.c_str());
  std::fflush(stderr);
}

void ProgressBar::done() {
  if (!m_line.empty()) std::fputs("\r\033[K", stderr);
}

}  // namespace hogelscope
