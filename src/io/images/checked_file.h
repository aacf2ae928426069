// SPDX-License-Identifier: BSD-3-Clause
// Writes the bytes of a new image and keeps the first error.
#pragma once

#include <cstdio>

#include "io/images/codecs.h"

namespace hogelscope {

class CheckedFile final : public ByteOutput {
 public:
  /// Writes to a copy of `descriptor`.
  explicit CheckedFile(int descriptor);
  CheckedFile(const CheckedFile&) = delete;
  CheckedFile& operator=(const CheckedFile&) = delete;
  ~CheckedFile() override { close(); }

  void seek(std::int64_t pos) override;
  void write(const void* data, std::size_t size) override;
  std::size_t read(void* data, std::size_t size) override;
  [[nodiscard]] std::size_t size() const override { return m_end; }
  void flush() override;
  void close();
  /// Returns errno of the first failure, or 0; complete after close().
  [[nodiscard]] int error() const { return m_error; }

 private:
  bool check(bool isDone);

  std::FILE* m_file = nullptr;
  std::size_t m_pos = 0;
  std::size_t m_end = 0;
  int m_error = 0;
};

}  // namespace hogelscope
