// SPDX-License-Identifier: BSD-3-Clause
#include "cli/stop_signals.h"

#include <poll.h>
#include <semaphore.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>

#include "io/files/temporary_files.h"

namespace hogelscope {

namespace {

volatile std::sig_atomic_t signalThatCame = 0;
volatile std::sig_atomic_t isWatched = 0;
std::atomic<bool> isHeard = false;
sem_t signals;

void remember(int signal) {
  const int error = errno;
  signalThatCame = signal;
  ::sem_post(&signals);
  if (isWatched == 0) std::signal(signal, SIG_DFL);
  errno = error;
}

/// A shell's `job &` ignores SIGINT, since Ctrl-C is for the job in front: it stays so.
void catchUnlessIgnored(int signal) {
  struct sigaction before {};
  if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) return;
  std::signal(signal, remember);
}

/// Waits for another signal. Returns false if none arrives.
bool signalComesWithin(long milliseconds) {
  constexpr long nanosecondsPerSecond = 1000000000;
  timespec end{};
  ::clock_gettime(CLOCK_MONOTONIC, &end);
  const long nanoseconds = end.tv_nsec + milliseconds * 1000000;
  end.tv_sec += nanoseconds / nanosecondsPerSecond;
  end.tv_nsec = nanoseconds % nanosecondsPerSecond;
  while (::sem_clockwait(&signals, CLOCK_MONOTONIC, &end) != 0)
    if (errno != EINTR) return false;
  return true;
}

/// Runs on its own thread, because a signal handler must not take locks.
void watch() {
  constexpr long unheard = 300;
  constexpr long longest = 5000;
  while (::sem_wait(&signals) != 0) {
  }
  if (!signalComesWithin(unheard) && isHeard) (void)signalComesWithin(longest - unheard);
  endBySignal();
}

/// Prints without stdio, whose lock a hanging thread may hold, and only if that does not block.
void sayStopped() {
  const std::string line = std::string(::isatty(STDERR_FILENO) == 1 ? "\n" : "") +
                           "hogelscope: stopped; what is finished is kept\n";
  pollfd place{STDERR_FILENO, POLLOUT, 0};
  if (::poll(&place, 1, 0) == 1) (void)!::write(STDERR_FILENO, line.data(), line.size());
}

}  // namespace

void catchSignals() {
  ::sem_init(&signals, 0, 0);
  try {
    std::thread(watch).detach();
    isWatched = 1;
  } catch (const std::system_error&) {  // no thread: a second signal ends at once
  }
  catchUnlessIgnored(SIGINT);
  catchUnlessIgnored(SIGTERM);
}

bool mustStop() {
  if (signalThatCame == 0) return false;
  isHeard = true;
  return true;
}

void endBySignal() {
  static std::once_flag once;
  std::call_once(once, [] {
    removeTemporaries();
    sayStopped();
    std::signal(signalThatCame, SIG_DFL);
    std::raise(signalThatCame);
  });
  std::_Exit(128 + signalThatCame);  // reached if the signal is blocked
}

}  // namespace hogelscope
