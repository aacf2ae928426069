// SPDX-License-Identifier: BSD-3-Clause
#include "io/store/block_cache.h"

namespace hogelscope {

BlockTexels BlockCache::find(std::uint64_t key) {
  Part& part = partOf(key);
  const std::lock_guard lock(part.mutex);
  const auto found = part.places.find(key);
  if (found == part.places.end()) return nullptr;
  part.entries.splice(part.entries.begin(), part.entries, found->second);
  return found->second->texels;
}

void BlockCache::put(std::uint64_t key, const BlockTexels& texels) {
  Part& part = partOf(key);
  const std::lock_guard lock(part.mutex);
  if (m_partBlocks == 0 || part.places.contains(key)) return;
  if (part.entries.size() == m_partBlocks) {
    part.places.erase(part.entries.back().key);
    part.entries.pop_back();
  }
  part.entries.push_front({key, texels});
  part.places[key] = part.entries.begin();
}

}  // namespace hogelscope
