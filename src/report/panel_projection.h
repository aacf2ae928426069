// SPDX-License-Identifier: BSD-3-Clause
// A test's error projected onto the panel, accumulated over the states and saved for resuming.
#pragma once

#include <chrono>
#include <filesystem>
#include <mutex>
#include <set>

#include "core/metrics/panel_error.h"
#include "report/view_pairs.h"

namespace hogelscope {

class PanelProjection {
 public:
  /// Resumes what an earlier run with the same `key` left in `file`.
  PanelProjection(std::filesystem::path file, std::string key, const LightFieldSize& size,
                  bool isDeep);

  [[nodiscard]] bool has(std::size_t state) const { return m_states.contains(state); }
  [[nodiscard]] const PanelError& error() const { return m_error; }
  /// Adds a state, from any thread, and saves every few seconds. Throws InputError (full disk),
  /// Cancelled.
  void add(std::size_t state, std::size_t worker, const ViewPair& pair, ViewPairs& pairs,
           const Progress& progress);
  void save();
  /// Adds the states that a shard with the same key has saved in `file`, unless one of them is
  /// present already. Throws InputError.
  void join(const std::filesystem::path& file);
  /// Removes the file after the report has been written.
  void remove();

 private:
  std::filesystem::path m_file;
  std::string m_key;
  std::mutex m_mutex;
  std::set<std::size_t> m_states;
  PanelError m_error;
  std::chrono::steady_clock::time_point m_saved = std::chrono::steady_clock::now();
};

}  // namespace hogelscope
