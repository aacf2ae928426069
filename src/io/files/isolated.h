// SPDX-License-Identifier: BSD-3-Clause
// Runs a library that damaged files can crash in a process of its own.
#pragma once

#include <sys/types.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <mutex>
#include <shared_mutex>
#include <stdexcept>
#include <string>

#include "core/base/progress.h"

namespace hogelscope {

/// A copy of this process (fork) that answers requests. It has one thread, none of this process'
/// open files and nowhere to write but its answers; beyond what this process has it gets 1 GB of
/// memory, or allowedMemory() if that is less. From several threads one request waits for the
/// other.
class Isolated {
 public:
  /// Answers a request, in the other process. Throws InputError.
  using Service = std::function<std::string(const std::string& request)>;

  /// `start` makes the service, in the other process, when there is a first request, or the next
  /// one after one was cancelled or has ended it. Messages name `file`.
  Isolated(std::filesystem::path file, std::function<Service()> start);
  ~Isolated();
  Isolated(const Isolated&) = delete;
  Isolated& operator=(const Isolated&) = delete;

  /// Throws InputError that names the file: what the service throws, or that the other process
  /// ended, which it also does after ten seconds of processor time or two minutes for one request;
  /// Cancelled, which it asks for while it waits.
  std::string ask(const std::string& request, const Progress& progress = {});

  /// Held (shared) while this process calls libraries that the copy calls, too: a lock of theirs
  /// that another thread holds when the copy is made would be held there for ever.
  static std::shared_mutex& librariesInUse();

 private:
  void start();
  void stop();
  void receive(char* to, std::size_t bytes, const Progress& progress) const;

  std::filesystem::path m_file;
  std::function<Service()> m_start;
  std::mutex m_mutex;
  pid_t m_process = -1;
  int m_socket = -1;
};

/// A request or an answer, as bytes; T has no pointers.
template <class T>
std::string messageOf(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// The beginning of a message.
template <class T>
T valueOf(const std::string& message) {
  T value;
  if (message.size() < sizeof value) throw std::logic_error("Isolated: a message is too short");
  std::memcpy(&value, message.data(), sizeof value);
  return value;
}

}  // namespace hogelscope
