// SPDX-License-Identifier: BSD-3-Clause
// Writes the bytes of a new image and keeps the first error.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "io/images/codecs.h"

namespace hogelscope {

class CheckedFile final : public ByteOutput {
 public:
  /// Writes to a copy of `descriptor`.
  explicit CheckedFile(int descriptor) {
    const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
    if (copy >= 0) m_file = ::fdopen(copy, "wb+");
    check(m_file != nullptr);
    if (m_file == nullptr && copy >= 0) ::close(copy);
  }
  CheckedFile(const CheckedFile&) = delete;
  CheckedFile& operator=(const CheckedFile&) = delete;
  ~CheckedFile() override { close(); }

  void seek(std::int64_t pos) override {
    m_pos = std::size_t(pos);
    check(m_file != nullptr && ::fseeko(m_file, pos, SEEK_SET) == 0);
  }

  void write(const void* data, std::size_t size) override {
    check(m_file != nullptr && std::fwrite(data, 1, size, m_file) == size);
    m_pos += size;
    m_end = std::max(m_end, m_pos);
  }

  std::size_t read(void* data, std::size_t size) override {
    return m_file == nullptr ? 0 : std::fread(data, 1, size, m_file);
  }

  [[nodiscard]] std::size_t size() const override { return m_end; }
  void flush() override { check(m_file != nullptr && std::fflush(m_file) == 0); }

  void close() {
    if (m_file == nullptr) return;
    struct stat status {};
    flush();
    if (check(::fstat(::fileno(m_file), &status) == 0) && std::size_t(status.st_size) != m_end)
      m_error = m_error == 0 ? EIO : m_error;
    check(std::fclose(std::exchange(m_file, nullptr)) == 0);
  }

  /// Returns errno of the first failure, or 0; complete after close().
  [[nodiscard]] int error() const { return m_error; }

 private:
  bool check(bool isDone) {
    if (!isDone && m_error == 0) m_error = errno != 0 ? errno : EIO;
    return isDone;
  }

  std::FILE* m_file = nullptr;
  std::size_t m_pos = 0;
  std::size_t m_end = 0;
  int m_error = 0;
};

}  // namespace hogelscope
