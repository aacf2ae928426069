// SPDX-License-Identifier: BSD-3-Clause
// A cache of a store's decoded blocks, limited in bytes, with least-recently-used eviction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace hogelscope {

using BlockTexels = std::shared_ptr<std::byte[]>;

/// A thread-safe cache in parts with a lock each. Blocks that it returns must not be changed.
class BlockCache {
 public:
  /// Creates a cache of `bytes` for blocks of `blockBytes` each.
  BlockCache(std::size_t bytes, std::size_t blockBytes)
      : m_partBlocks(bytes / blockBytes / parts) {}

  /// Returns a block, or null.
  BlockTexels find(std::uint64_t key) {
    Part& part = partOf(key);
    const std::lock_guard lock(part.mutex);
    const auto found = part.places.find(key);
    if (found == part.places.end()) return nullptr;
    part.entries.splice(part.entries.begin(), part.entries, found->second);
    return found->second->texels;
  }

  void put(std::uint64_t key, const BlockTexels& texels) {
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

 private:
  static constexpr std::size_t parts = 16;
  struct Entry {
    std::uint64_t key = 0;
    BlockTexels texels;
  };
  struct Part {
    std::mutex mutex;
    std::list<Entry> entries;  ///< most recently used first
    std::unordered_map<std::uint64_t, std::list<Entry>::iterator> places;
  };
  Part& partOf(std::uint64_t key) { return m_parts[key % parts]; }

  std::size_t m_partBlocks;
  std::vector<Part> m_parts = std::vector<Part>(parts);
};

}  // namespace hogelscope
