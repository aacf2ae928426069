// SPDX-License-Identifier: BSD-3-Clause
// Runs a library that may crash for damaged files in a separate process.
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

/// A forked copy of this process that answers requests. It has one thread, none of this process'
/// open files, and can only write its answers; beyond the memory of this process it gets 1 GB, or
/// allowedMemory() if that is less. Requests of several threads run one after the other.
class Isolated {
 public:
  /// Answers a request, in the other process. Throws InputError.
  using Service = std::function<std::string(const std::string& request)>;

  /// `start` creates the service in the other process, for the first request and after one that was
  /// cancelled or ended the process. Messages name `file`.
  Isolated(std::filesystem::path file, std::function<Service()> start);
  ~Isolated();
  Isolated(const Isolated&) = delete;
  Isolated& operator=(const Isolated&) = delete;

  /// Sends a request and returns the answer. Throws InputError that names the file: the service's
  /// error, or that the other process ended, also after ten seconds of processor time or two
  /// minutes for one request. Throws Cancelled.
  std::string ask(const std::string& request, const Progress& progress = {});

  /// Returns a mutex to hold (shared) while this process calls libraries that the copy calls too.
  /// Otherwise a lock of theirs that another thread holds during the fork would stay locked in the
  /// copy.
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

/// Converts a request or an answer to bytes; T has no pointers.
template <class T>
std::string messageOf(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// Returns the value at the beginning of a message.
template <class T>
T valueOf(const std::string& message) {
  T value;
  if (message.size() < sizeof value) throw std::logic_error("Isolated: a message is too short");
  std::memcpy(&value, message.data(), sizeof value);
  return value;
}

}  // namespace hogelscope
