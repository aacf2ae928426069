// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/random_access_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/error.h"

namespace hogelscope {

Descriptor::~Descriptor() {
  if (m_fd >= 0) ::close(m_fd);
}

RandomAccessFile::RandomAccessFile(const std::filesystem::path& path)
    : m_path(path), m_descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  struct stat status {};
  if (m_descriptor.get() < 0 || ::fstat(m_descriptor.get(), &status) != 0)
    throw InputError(path.string(), "cannot be read", std::strerror(errno));
  if (!S_ISREG(status.st_mode)) throw InputError(path.string(), "", "is not a file");
  m_size = std::uint64_t(status.st_size);
}

std::size_t RandomAccessFile::readSome(std::uint64_t at, std::span<std::byte> bytes) const {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::pread(m_descriptor.get(), bytes.data() + done, bytes.size() - done,
                                static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw InputError(m_path.string(), "cannot be read", std::strerror(errno));
    if (got == 0) break;
    done += std::size_t(got);
  }
  return done;
}

void RandomAccessFile::read(std::uint64_t at, std::span<std::byte> bytes) const {
  if (at > m_size || bytes.size() > m_size - at || readSome(at, bytes) < bytes.size())
    throw InputError(m_path.string(), "is damaged", "it ends too early");
}

}  // namespace hogelscope
