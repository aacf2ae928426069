// SPDX-License-Identifier: BSD-3-Clause
#include "reading.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
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
  // Pipes and devices would never end.
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) fail(file, "cannot be read", std::strerror(ENOENT));
  if (!std::filesystem::is_regular_file(status)) fail(file, "cannot be read", "is not a file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> input(std::fopen(file.c_str(), "rbe"),
                                                              &std::fclose);
  if (!input) fail(file, "cannot be read", std::strerror(errno));
  const auto size = std::size_t(std::filesystem::file_size(file));
  take(double(size));
  std::string bytes(size, '\0');
  std::size_t read = 0;
  for (std::size_t more = 1; more > 0 && read < size; read += more) {
    poll();
    constexpr std::size_t piece = std::size_t{1} << 24U;
    more = std::fread(bytes.data() + read, 1, std::min(piece, size - read), input.get());
  }
  bytes.resize(read);
  if (std::ferror(input.get()) != 0) fail(file, "cannot be read", std::strerror(errno));
  return bytes;
}

void Reading::report(std::size_t read, std::size_t bytes) {
  constexpr double share = 0.5;  // of the time of opening
  m_done = std::max(m_done, share * double(read) / double(bytes));
  poll();
}

void Reading::poll() const {
  if (!m_progress.go(m_done)) throw std::runtime_error("stopped");
}

}  // namespace hogelscope::mesh
