// SPDX-License-Identifier: BSD-3-Clause
// Decoded blocks of a store, within a number of bytes.
#include "io/block_cache.h"

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
  if (texels->size() > m_partBytes || part.places.contains(key)) return;
  part.bytes += texels->size();
  while (part.bytes > m_partBytes) {
    part.bytes -= part.entries.back().texels->size();
    part.places.erase(part.entries.back().key);
    part.entries.pop_back();
  }
  part.entries.push_front({key, texels});
  part.places[key] = part.entries.begin();
}

}  // namespace hogelscope
