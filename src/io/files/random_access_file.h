// SPDX-License-Identifier: BSD-3-Clause
// A file that several threads read at any position.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

namespace hogelscope {

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int fd) : m_fd(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : m_fd(std::exchange(other.m_fd, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(m_fd, other.m_fd);
    return *this;
  }
  ~Descriptor();
  [[nodiscard]] int get() const { return m_fd; }

 private:
  int m_fd;
};

class RandomAccessFile {
 public:
  /// Opens a file. Throws InputError if it is missing, not a regular file, or unreadable.
  explicit RandomAccessFile(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
  [[nodiscard]] std::uint64_t size() const { return m_size; }

  /// Fills `bytes` from the position `at`. Throws InputError if the file is shorter.
  void read(std::uint64_t at, std::span<std::byte> bytes) const;
  /// Reads as many of the bytes as exist. Returns their number.
  std::size_t readSome(std::uint64_t at, std::span<std::byte> bytes) const;

 private:
  std::filesystem::path m_path;
  Descriptor m_descriptor;
  std::uint64_t m_size = 0;
};

}  // namespace hogelscope
