// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/content_hash.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>

#include "core/base/error.h"
#include "io/files/random_access_file.h"

namespace hogelscope {

namespace fs = std::filesystem;

void ContentHash::Free::operator()(XXH3_state_s* state) const {
  XXH3_freeState(state);
}

ContentHash::ContentHash() : m_state(XXH3_createState()) {
  if (!m_state) throw std::bad_alloc();
  XXH3_128bits_reset(m_state.get());
}

void ContentHash::add(std::span<const std::byte> bytes) {
  XXH3_128bits_update(m_state.get(), bytes.data(), bytes.size());
}

std::string ContentHash::hex() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(m_state.get());
  std::array<char, 33> text{};
  std::snprintf(text.data(), text.size(), "%016llx%016llx",
                static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text.data();
}

namespace {

std::string hashOf(const fs::path& path, const Progress& progress) {
  const auto failed = [&path] {
    return InputError(path.string(), "cannot be read", std::strerror(errno));
  };
  // Without O_NONBLOCK a pipe would wait for its writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat facts {};
  if (file.get() < 0 || ::fstat(file.get(), &facts) != 0) throw failed();
  if (!S_ISREG(facts.st_mode) && !S_ISDIR(facts.st_mode))
    throw InputError(path.string(), "", "is a device or a pipe, not a file");
  ContentHash hash;
  std::vector<std::byte> block(std::size_t{1} << 20);
  while (true) {
    throwIfCancelled(progress);
    const ssize_t bytes = ::read(file.get(), block.data(), block.size());
    if (bytes == 0) return hash.hex();
    if (bytes > 0)
      hash.add(std::span(block).first(std::size_t(bytes)));
    else if (errno != EINTR)
      throw failed();
  }
}

}  // namespace

std::string contentHash(const std::vector<fs::path>& files, const Progress& progress) {
  if (files.size() == 1) return hashOf(files.front(), progress);
  std::string lines;
  for (const fs::path& file : files)
    lines += hashOf(file, progress) + "  " + file.filename().string() + "\n";
  return contentHash(lines);
}

std::string contentHash(const std::string& text) {
  ContentHash hash;
  hash.add(std::as_bytes(std::span(text)));
  return hash.hex();
}

std::string fileIdentity(const fs::path& file) {
  struct stat facts {};
  if (::stat(file.c_str(), &facts) != 0) return {};
  const auto text = [](const timespec& time) {
    return std::to_string(time.tv_sec) + "." + std::to_string(time.tv_nsec);
  };
  return std::to_string(facts.st_dev) + " " + std::to_string(facts.st_ino) + " " +
         text(facts.st_ctim) + " " + text(facts.st_mtim) + " " + std::to_string(facts.st_size);
}

}  // namespace hogelscope
