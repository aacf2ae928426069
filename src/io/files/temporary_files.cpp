// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/temporary_files.h"

#include <mutex>
#include <set>

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

struct Registry {
  std::mutex mutex;
  std::multiset<fs::path> files;
};

/// Returns the registry, which is never destroyed, because a signal may arrive while main()
/// returns.
Registry& registry() {
  static auto* const only = new Registry;
  return *only;
}

}  // namespace

void registerTemporary(const fs::path& file) {
  const std::lock_guard lock(registry().mutex);
  registry().files.insert(file);
}

void forgetTemporary(const fs::path& file) {
  const std::lock_guard lock(registry().mutex);
  const auto found = registry().files.find(file);
  if (found != registry().files.end()) registry().files.erase(found);
}

void removeTemporaries() {
  registry().mutex.lock();  // never unlocked
  std::error_code ignored;
  for (const fs::path& file : registry().files) fs::remove(file, ignored);
}

}  // namespace hogelscope
