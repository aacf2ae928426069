// SPDX-License-Identifier: BSD-3-Clause
#include "runs/file_hashes.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/atomic_file.h"
#include "io/files/content_hash.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view cacheHead = "hogelscope hashes 1\n";
constexpr std::size_t hashDigits = 32;

Descriptor lockedCache(const fs::path& cache, const Progress& progress) {
  for (;;) {
    if (auto descriptor = openLocked(cache, O_APPEND)) return std::move(*descriptor);
    throwIfCancelled(progress);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

}  // namespace

FileHashes::FileHashes(const fs::path& folder) : m_cache(folder / "report.hashes") {
  requireOwnFile(m_cache, cacheHead);
  read();
}

std::string FileHashes::identityOf(const fs::path& file) {
  std::error_code none;
  // On one line, because a name with a line end could insert the hash of another file.
  return fileIdentity(file) + " " + printable(fs::absolute(file, none).lexically_normal().string());
}

/// Reads the cache and ignores lines that a crash or a full disk has truncated.
void FileHashes::read() {
  std::ifstream in(m_cache, std::ios::binary);
  for (std::string line; std::getline(in, line);)
    if (line.size() > hashDigits && line[hashDigits] == ' ' && !in.eof())
      m_hashes[line.substr(hashDigits + 1)] = line.substr(0, hashDigits);
}

std::string FileHashes::of(const std::vector<fs::path>& files, const Progress& progress) {
  std::vector<std::string> identities(files.size());
  std::ranges::transform(files, identities.begin(), identityOf);
  const auto isKnown = [this](const std::string& identity) { return m_hashes.contains(identity); };
  if (!std::ranges::all_of(identities, isKnown)) complete(files, identities, progress);
  if (files.size() == 1) return m_hashes[identities.front()];
  std::string lines;
  for (std::size_t k = 0; k < files.size(); ++k)
    lines += m_hashes[identities[k]] + "  " + files[k].filename().string() + "\n";
  return contentHash(lines);
}

void FileHashes::remove() {
  std::error_code ignored;
  fs::remove(m_cache, ignored);
}

/// Computes the hashes that neither this process nor another has.
void FileHashes::complete(const std::vector<fs::path>& files,
                          const std::vector<std::string>& identities, const Progress& progress) {
  const Descriptor cache = lockedCache(m_cache, progress);
  read();
  if (::lseek(cache.get(), 0, SEEK_END) == 0) writeAll(cache.get(), cacheHead, m_cache);
  for (std::size_t k = 0; k < files.size(); ++k) {
    std::string& hash = m_hashes[identities[k]];
    if (!hash.empty()) continue;
    hash = contentHash(std::vector<fs::path>{files[k]}, progress);
    // Starts a new line, because the last one may be truncated.
    writeAll(cache.get(), "\n" + hash + " " + identities[k] + "\n", m_cache);
  }
}

}  // namespace hogelscope
