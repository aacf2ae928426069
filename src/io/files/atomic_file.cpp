// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <random>
#include <system_error>
#include <thread>

#include "core/base/error.h"
#include "io/files/files_in_use.h"
#include "io/files/folders.h"
#include "io/files/temporary_files.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

InputError cannotWrite(const fs::path& path, int error) {
  return {path.string(), "cannot be written", std::strerror(error)};
}

/// Returns the file that a path refers to: its target, if it is a symbolic link.
fs::path resolved(fs::path path) {
  constexpr int mostLinks = 16;
  std::error_code none;
  for (int k = 0; k < mostLinks && fs::is_symlink(path, none); ++k)
    path = path.parent_path() / fs::read_symlink(path, none);
  return path;
}

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

constexpr std::string_view temporaryHead = ".hogelscope-";
constexpr std::string_view temporaryEnd = ".part";

/// Returns a name beside `path` that cannot be guessed.
fs::path randomNameFor(const fs::path& path) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device random;
  std::string name(temporaryHead);
  for (int k = 0; k < 12; ++k) name += letters[random() % letters.size()];
  return folderOf(path) / (name += temporaryEnd);
}

/// Returns the path by which linkat() finds a file without a name; needs /proc.
std::string linkTo(int descriptor) {
  return "/proc/self/fd/" + std::to_string(descriptor);
}

/// Opens a file without a name in the folder of `path`; -1 if the file system does not support it.
int openUnnamed(const fs::path& path) {
  const int descriptor = ::open(folderOf(path).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
  if (descriptor >= 0 && ::access(linkTo(descriptor).c_str(), F_OK) == 0) return descriptor;
  if (descriptor >= 0) ::close(descriptor);
  return -1;
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path)
    : m_path(resolved(path)), m_descriptor(openUnnamed(m_path)) {
  std::error_code none;
  if (fs::exists(m_path, none) && !fs::is_regular_file(m_path, none))
    throw InputError(path.string(), "cannot be written", "it is there, and is not a file");
  requireUnused(path);
  if (m_descriptor.get() < 0) openNamed();
}

AtomicFile::~AtomicFile() {
  if (m_temporary.empty()) return;
  ::unlink(m_temporary.c_str());
  forgetTemporary(m_temporary);
}

void AtomicFile::takeName(const fs::path& name) {
  registerTemporary(name);
  m_temporary = name;
}

void AtomicFile::dropName() {
  forgetTemporary(m_temporary);
  m_temporary.clear();
}

void AtomicFile::openNamed() {
  takeName(randomNameFor(m_path));
  constexpr int flags = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  m_descriptor = Descriptor(::open(m_temporary.c_str(), flags, 0666));
  if (m_descriptor.get() >= 0) return;
  const int error = errno;
  dropName();  // not owned by this object
  throw cannotWrite(m_path, error);
}

void AtomicFile::giveName() {
  takeName(randomNameFor(m_path));
  if (::linkat(AT_FDCWD, linkTo(descriptor()).c_str(), AT_FDCWD, m_temporary.c_str(),
               AT_SYMLINK_FOLLOW) == 0)
    return;
  const int error = errno;
  dropName();
  throw cannotWrite(m_path, error);
}

void AtomicFile::commit() {
  requireUnused(m_path);
  syncToDisk(descriptor(), m_path);
  struct stat old {};
  if (::stat(m_path.c_str(), &old) == 0) (void)::fchmod(descriptor(), old.st_mode & 07777U);
  if (m_temporary.empty()) giveName();
  if (::rename(m_temporary.c_str(), m_path.c_str()) != 0) throw cannotWrite(m_path, errno);
  dropName();
}

void writeAll(int descriptor, std::string_view text, const fs::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw cannotWrite(path, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void syncToDisk(int descriptor, const fs::path& path) {
  // Some file systems do not support it: EINVAL, EROFS.
  if (::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS) throw cannotWrite(path, errno);
}

void writeTextFile(const fs::path& path, std::string_view text) {
  AtomicFile file(path);
  writeAll(file.descriptor(), text, path);
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
  checkWritable(folder);
}

void requireOwnFile(const fs::path& path, std::string_view head) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 && errno == ENOENT) return;
  std::string found(head.size(), '\0');
  if (S_ISREG(status.st_mode)) {
    const RandomAccessFile file(path);
    found.resize(file.readSome(0, std::as_writable_bytes(std::span(found))));
  }
  if (!S_ISREG(status.st_mode) || !head.starts_with(found))
    throw InputError(path.string(), "cannot be written",
                     "it is there, and was not written by hogelscope: move it away");
}

std::optional<Descriptor> openLocked(const fs::path& path, int moreFlags) {
  constexpr int tries = 10;  // isLocked() of another process briefly holds the lock
  for (int failed = 0; failed < tries;) {
    Descriptor file(
        ::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | moreFlags, 0666));
    if (file.get() < 0) throw cannotWrite(path, errno);
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
      ++failed;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      continue;
    }
    // The other process may have renamed or deleted the file between open() and flock().
    struct stat locked {};
    struct stat named {};
    if (::fstat(file.get(), &locked) == 0 && ::lstat(path.c_str(), &named) == 0 &&
        locked.st_ino == named.st_ino && locked.st_dev == named.st_dev)
      return file;
  }
  return std::nullopt;
}

void removeLeftovers(const fs::path& folder) {
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(temporaryHead) && name.ends_with(temporaryEnd))
      fs::remove(entry.path(), none);
  }
}

bool isLocked(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
  return file.get() >= 0 && ::flock(file.get(), LOCK_SH | LOCK_NB) != 0;
}

}  // namespace hogelscope
