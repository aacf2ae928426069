// SPDX-License-Identifier: BSD-3-Clause
#include "reading.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "errors.h"

namespace hogelscope::mesh {

namespace {

std::string bytesText(double bytes) {
  constexpr std::array<const char*, 4> units{"B", "kB", "MB", "GB"};
  std::size_t unit = 0;
  for (; bytes >= 1000 && unit + 1 < units.size(); ++unit) bytes /= 1000;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g %s", bytes, units[unit]);
  return text.data();
}

}  // namespace

Reading::Reading(std::string file, std::uint64_t memory, const plugin::Progress& progress)
    : m_file(std::move(file)), m_memory(double(memory)), m_progress(progress) {}

void Reading::take(double bytes) {
  m_taken += bytes;
  if (m_taken <= m_memory) return;
  fail(m_file, "needs " + bytesText(m_taken) + " of memory or more",
       bytesText(m_memory) + " are allowed: use a smaller mesh or textures, or allow more");
}

std::string Reading::bytesOf(const std::string& file) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (!error) take(double(bytes));
  poll();
  return readBytes(file);
}

void Reading::report(std::size_t read, std::size_t bytes) {
  constexpr double share = 0.5;  // of opening
  m_done = std::max(m_done, share * double(read) / double(bytes));
  poll();
}

void Reading::poll() const {
  if (!m_progress.go(m_done)) throw std::runtime_error("stopped");
}

}  // namespace hogelscope::mesh
