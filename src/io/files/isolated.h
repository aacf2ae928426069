// SPDX-License-Identifier: BSD-3-Clause
// Runs a library that damaged files can crash in a process of its own.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>

#include "core/base/progress.h"

namespace hogelscope {

/// A copy of this process (fork) that answers requests. It has one thread, none of this process'
/// open files and nowhere to write but its answers. From several threads one request waits for the
/// other.
class Isolated {
 public:
  /// Answers a request, in the other process. Throws InputError without a file.
  using Service = std::function<std::string(const std::string& request)>;

  /// `start` makes the service, in the other process, when there is a first request, or the next
  /// one after one was cancelled or has ended it. Messages name `file`.
  Isolated(std::filesystem::path file, std::function<Service()> start);
  ~Isolated();
  Isolated(const Isolated&) = delete;
  Isolated& operator=(const Isolated&) = delete;

  /// Throws InputError that names the file: what the service throws, or that the other process
  /// ended or takes longer than two minutes; Cancelled, which it asks for while it waits.
  std::string ask(const std::string& request, const Progress& progress = {});

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

}  // namespace hogelscope
