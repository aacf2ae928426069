// SPDX-License-Identifier: BSD-3-Clause
// Files that are there whole or not at all.
#include "io/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/error.h"
#include "io/temporary_files.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

InputError cannotWrite(const fs::path& path, int error) {
  return {path.string(), "cannot be written", std::strerror(error)};
}

/// A file descriptor that is closed again.
struct Descriptor {
  int fd;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

void writeAll(int fd, std::string_view text, const fs::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(fd, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw cannotWrite(path, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : m_path(path) {
  constexpr int mostLinks = 16;
  std::error_code none;
  for (int k = 0; k < mostLinks && fs::is_symlink(m_path, none); ++k)
    m_path = m_path.parent_path() / fs::read_symlink(m_path, none);
  if (fs::exists(m_path, none) && !fs::is_regular_file(m_path, none))
    throw InputError(path.string(), "cannot be written", "it is there, and is not a file");
  m_temporary = m_path.parent_path() / ("." + m_path.stem().string() + ".part");
  m_temporary += m_path.extension();
  registerTemporary(m_temporary);
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  fs::remove(m_temporary, ignored);
  forgetTemporary(m_temporary);
}

void AtomicFile::commit() {
  std::error_code error;
  const fs::file_status old = fs::status(m_path, error);  // who may read it stays as it was
  if (fs::exists(old)) fs::permissions(m_temporary, old.permissions(), error);
  error.clear();
  fs::rename(m_temporary, m_path, error);
  if (error) throw cannotWrite(m_path, error.value());
}

void writeTextFile(const fs::path& path, std::string_view text) {
  AtomicFile file(path);
  const Descriptor out{
      ::open(file.temporary().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)};
  if (out.fd < 0) throw cannotWrite(path, errno);
  writeAll(out.fd, text, path);
  if (::fsync(out.fd) != 0 && errno != EINVAL && errno != EROFS) throw cannotWrite(path, errno);
  file.commit();
}

std::string readTextFile(const fs::path& path) {
  constexpr std::size_t largest = std::size_t{64} << 20;
  std::error_code error;
  if (fs::is_directory(path, error)) throw InputError(path.string(), "", "is a folder, not a file");
  if (fs::exists(path, error) && !fs::is_regular_file(path, error))
    throw InputError(path.string(), "", "is a device or a pipe, not a file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path.string(), "cannot be read", std::strerror(errno));
  std::string text;
  std::array<char, 65536> block{};
  while (in.read(block.data(), block.size()), in.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > largest)
      throw InputError(path.string(), "", "is larger than 64 MiB: not a document of ours");
  }
  return text;
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "cannot be made", error.message());
}

}  // namespace hogelscope
