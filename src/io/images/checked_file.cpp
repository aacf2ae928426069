// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/checked_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace hogelscope {

CheckedFile::CheckedFile(int descriptor) {
  const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (copy >= 0) m_file = ::fdopen(copy, "wb+");
  check(m_file != nullptr);
  if (m_file == nullptr && copy >= 0) ::close(copy);
}

void CheckedFile::seek(std::int64_t pos) {
  m_pos = std::size_t(pos);
  check(m_file != nullptr && ::fseeko(m_file, pos, SEEK_SET) == 0);
}

void CheckedFile::write(const void* data, std::size_t size) {
  check(m_file != nullptr && std::fwrite(data, 1, size, m_file) == size);
  m_pos += size;
  m_end = std::max(m_end, m_pos);
}

std::size_t CheckedFile::read(void* data, std::size_t size) {
  return m_file == nullptr ? 0 : std::fread(data, 1, size, m_file);
}

void CheckedFile::flush() {
  check(m_file != nullptr && std::fflush(m_file) == 0);
}

void CheckedFile::close() {
  if (m_file == nullptr) return;
  struct stat status {};
  flush();
  if (check(::fstat(::fileno(m_file), &status) == 0) && std::size_t(status.st_size) != m_end)
    m_error = m_error == 0 ? EIO : m_error;
  check(std::fclose(std::exchange(m_file, nullptr)) == 0);
}

bool CheckedFile::check(bool isDone) {
  if (!isDone && m_error == 0) m_error = errno != 0 ? errno : EIO;
  return isDone;
}

}  // namespace hogelscope
