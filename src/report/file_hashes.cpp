// SPDX-License-Identifier: BSD-3-Clause
// Hashes of files, kept beside a report.
#include "report/file_hashes.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/base/error.h"
#include "io/files/atomic_file.h"
#include "report/file_hash.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view head = "{\"hogelscope hashes\":1}\n";

Descriptor lockedCache(const fs::path& cache, const Progress& progress) {
  for (;;) {
    if (auto descriptor = openLocked(cache, O_APPEND)) return std::move(*descriptor);
    hearStop(progress);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

}  // namespace

FileHashes::FileHashes(const fs::path& folder) : m_cache(folder / "report.hashes") {
  requireOurs(m_cache, head);
  read();
}

std::string FileHashes::identityOf(const fs::path& file) {
  std::error_code none;
  return Json{{"file", fs::absolute(file, none).lexically_normal().string()},
              {"bytes", fs::file_size(file, none)},
              {"changed", fs::last_write_time(file, none).time_since_epoch().count()}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Lines that a crash or a full disk has cut off count for nothing.
void FileHashes::read() {
  std::ifstream in(m_cache, std::ios::binary);
  for (std::string text; std::getline(in, text);) {
    Json line = Json::parse(text, nullptr, false);
    if (!line.is_object() || !line.contains("sha256") || !line["sha256"].is_string()) continue;
    const auto hash = line["sha256"].get<std::string>();
    line.erase("sha256");
    m_hashes[line.dump(-1, ' ', false, Json::error_handler_t::replace)] = hash;
  }
}

std::string FileHashes::of(const std::vector<fs::path>& files, const Progress& progress) {
  std::vector<std::string> identities;
  for (const fs::path& file : files) identities.push_back(identityOf(file));
  const auto isKnown = [this](const std::string& identity) { return m_hashes.contains(identity); };
  if (!std::ranges::all_of(identities, isKnown)) complete(files, identities, progress);
  if (files.size() == 1) return m_hashes[identities.front()];
  std::string lines;
  for (std::size_t k = 0; k < files.size(); ++k)
    lines += m_hashes[identities[k]] + "  " + files[k].filename().string() + "\n";
  return sha256(lines);
}

/// Hashes what neither this process nor another has.
void FileHashes::complete(const std::vector<fs::path>& files,
                          const std::vector<std::string>& identities, const Progress& progress) {
  const Descriptor cache = lockedCache(m_cache, progress);
  read();
  if (::lseek(cache.get(), 0, SEEK_END) == 0) writeAll(cache.get(), head, m_cache);
  for (std::size_t k = 0; k < files.size(); ++k) {
    std::string& hash = m_hashes[identities[k]];
    if (!hash.empty()) continue;
    hash = sha256(std::vector<fs::path>{files[k]}, progress);
    Json line = Json::parse(identities[k]);
    line["sha256"] = hash;
    writeAll(cache.get(), "\n" + line.dump() + "\n", m_cache);  // after one that was cut off, too
  }
}

}  // namespace hogelscope
