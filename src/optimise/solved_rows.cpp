// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/solved_rows.h"

#include <fstream>

#include "core/base/error.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

constexpr const char* rowEnding = ".row";
constexpr std::string_view rowHead = "hogelscope optimised row ";

}  // namespace

SolvedRows::SolvedRows(fs::path folder, const std::string& key, const std::optional<Shard>& shard)
    : m_folder(std::move(folder)), m_head(std::string(rowHead) + key + "\n"), m_shard(shard) {
  makeFolder(m_folder);
  for (const fs::path& entry : entriesOf(m_folder)) {
    if (entry.filename().string().starts_with('.')) continue;  // of a process that writes, or died
    if (entry.extension() != rowEnding)
      throw InputError(entry.string(), "is no row of hogels: move it, or choose another --output");
    requireOwnFile(entry, rowHead);
  }
}

fs::path SolvedRows::fileOf(int j) const {
  return m_folder / (std::to_string(j) + rowEnding);
}

std::optional<std::string> SolvedRows::read(int j) const {
  std::ifstream file(fileOf(j), std::ios::binary);
  std::string head(m_head.size(), '\0');
  if (!file.read(head.data(), std::streamsize(head.size())) || head != m_head) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void SolvedRows::write(int j, const std::string& bytes) const {
  AtomicFile file(fileOf(j));
  writeAll(file.descriptor(), m_head, fileOf(j));
  writeAll(file.descriptor(), bytes, fileOf(j));
  file.commit();
}

void SolvedRows::remove(const fs::path& folder) {
  removeLeftovers(folder);
  std::error_code none;
  for (const fs::path& entry : entriesOf(folder))
    if (entry.extension() == rowEnding) fs::remove(entry, none);
  fs::remove(folder, none);
}

}  // namespace hogelscope
