// SPDX-License-Identifier: BSD-3-Clause
// A progress bar on a terminal, and Ctrl-C as a clean stop.
#include "cli/progress_bar.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace hogelscope {

namespace {

volatile std::sig_atomic_t signalThatCame = 0;

void remember(int signal) {
  signalThatCame = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catchSignals() {
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

int caughtSignal() {
  return signalThatCame;
}

ProgressBar::ProgressBar(std::string what, bool quiet)
    : m_what(std::move(what)), m_isShown(!quiet && ::isatty(STDERR_FILENO) == 1) {}

Progress ProgressBar::progress() {
  return [this](double fraction) {
    draw(fraction);
    return signalThatCame == 0;
  };
}

void ProgressBar::draw(double fraction) {
  const int percent = static_cast<int>(100 * fraction);
  if (!m_isShown || percent == m_percent) return;
  m_percent = percent;
  constexpr int width = 40;
  const int filled = width * percent / 100;
  std::fprintf(stderr, "\r%s [%.*s%*s] %d %%", m_what.c_str(), filled,
               "########################################", width - filled, "", percent);
  std::fflush(stderr);
}

void ProgressBar::done() {
  if (m_isShown && m_percent >= 0) std::fputs("\r\033[K", stderr);
}

}  // namespace hogelscope
