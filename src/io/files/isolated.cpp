// SPDX-License-Identifier: BSD-3-Clause
// A forked process that answers requests.
#include "io/files/isolated.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <new>
#include <system_error>

#include "core/base/error.h"
#include "io/files/system_limits.h"

namespace hogelscope {

namespace {

constexpr unsigned longestAnswer = 120;  // seconds
constexpr time_t longestWork = 10;       // seconds of processor time
constexpr std::size_t mostMemory = std::size_t{1} << 30U;

struct Header {
  std::uint64_t bytes = 0;
  std::uint64_t isError = 0;
};

bool sendAll(int to, const void* data, std::size_t bytes) {
  const auto* from = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t sent = ::send(to, from, bytes, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    from += sent;
    bytes -= std::size_t(sent);
  }
  return true;
}

bool sendMessage(int to, const std::string& text, bool isError) {
  const Header header{text.size(), isError ? 1U : 0U};
  return sendAll(to, &header, sizeof header) && sendAll(to, text.data(), text.size());
}

/// Receives all bytes, without a time limit.
bool receiveAll(int from, void* data, std::size_t bytes) {
  auto* to = static_cast<char*>(data);
  while (bytes > 0) {
    const ssize_t read = ::recv(from, to, bytes, 0);
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return false;
    to += read;
    bytes -= std::size_t(read);
  }
  return true;
}

/// Closes this process' files and resets its signal handlers in the copy.
int becomeAlone(int socket) {
  constexpr int kept = 3;
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (int standard = 0; standard < kept; ++standard) ::dup2(nowhere, standard);
  if (socket != kept) ::dup2(socket, kept);
  ::close_range(kept + 1, ~0U, 0);
  for (int signal = 1; signal < NSIG; ++signal) (void)std::signal(signal, SIG_DFL);
  (void)std::signal(SIGINT, SIG_IGN);  // this process handles Ctrl-C, then ends the copy
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const rlimit noCore{0, 0};
  ::setrlimit(RLIMIT_CORE, &noCore);
  return kept;
}

/// Limits the copy's allocations beyond the data that it has from this process.
void limitMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word != "VmData:" || !(status >> kilobytes)) continue;
    const rlim_t most = kilobytes * 1024 + std::min(mostMemory, allowedMemory());
    const rlimit limit{most, most};
    ::setrlimit(RLIMIT_DATA, &limit);
    return;
  }
}

/// Sets the seconds after which a signal ends the process; 0: none.
void limitTime(unsigned answer, time_t work) {
  ::alarm(answer);
  const itimerval timer{{0, 0}, {work, 0}};
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

/// Answers requests until the other end of the socket is closed.
void serve(int socket, const std::function<Isolated::Service()>& start) {
  Isolated::Service service;
  Header header;
  while (receiveAll(socket, &header, sizeof header)) {
    std::string request(header.bytes, '\0');
    if (!receiveAll(socket, request.data(), request.size())) return;
    limitTime(longestAnswer, longestWork);
    std::string answer;
    bool isError = true;
    try {
      if (!service) service = start();
      answer = service(request);
      isError = false;
    } catch (const std::bad_alloc&) {
      answer = "not enough memory";
    } catch (const std::exception& error) {
      answer = error.what();
    }
    if (!sendMessage(socket, answer, isError)) return;
    limitTime(0, 0);
  }
}

}  // namespace

std::shared_mutex& Isolated::librariesInUse() {
  static std::shared_mutex mutex;
  return mutex;
}

Isolated::Isolated(std::filesystem::path file, std::function<Service()> start)
    : m_file(std::move(file)), m_start(std::move(start)) {}

Isolated::~Isolated() {
  stop();
}

void Isolated::start() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw InputError(m_file.string(), "cannot be read", std::generic_category().message(errno));
  {
    const std::unique_lock lock(librariesInUse());
    m_process = ::fork();
  }
  if (m_process == 0) {
    const int socket = becomeAlone(ends[1]);
    limitMemory();
    serve(socket, m_start);
    ::_exit(0);
  }
  ::close(ends[1]);
  m_socket = ends[0];
  if (m_process >= 0) return;
  const int error = errno;
  stop();
  throw InputError(m_file.string(), "cannot be read", std::generic_category().message(error));
}

void Isolated::stop() {
  if (m_socket >= 0) ::close(m_socket);
  m_socket = -1;
  if (m_process < 0) return;
  ::kill(m_process, SIGKILL);
  while (::waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {
  }
  m_process = -1;
}

void Isolated::receive(char* to, std::size_t bytes, const Progress& progress) const {
  while (bytes > 0) {
    throwIfCancelled(progress);
    pollfd waiting{m_socket, POLLIN, 0};
    constexpr int patience = 50;  // ms between checks for cancellation
    if (::poll(&waiting, 1, patience) <= 0) continue;
    const ssize_t read = ::recv(m_socket, to, bytes, 0);
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0)
      throw InputError(m_file.string(), "is damaged",
                       "the library that reads it crashed, hung, or wanted too much memory");
    to += read;
    bytes -= std::size_t(read);
  }
}

std::string Isolated::ask(const std::string& request, const Progress& progress) {
  const std::lock_guard lock(m_mutex);
  if (m_process < 0) start();
  Header header;
  std::string answer;
  try {
    sendMessage(m_socket, request, false);  // if the process has ended, receive() reports it
    receive(reinterpret_cast<char*>(&header), sizeof header, progress);
    answer.resize(header.bytes);
    receive(answer.data(), answer.size(), progress);
  } catch (...) {
    stop();
    throw;
  }
  if (header.isError == 0) return answer;
  const std::string name = m_file.string() + ": ";
  throw InputError(m_file.string(), "",
                   answer.starts_with(name) ? answer.substr(name.size()) : answer);
}

}  // namespace hogelscope
