// SPDX-License-Identifier: BSD-3-Clause
#include "python/picture_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>
#include <vector>

namespace hogelscope {

namespace {

constexpr std::size_t hugePage = std::size_t{1} << 21;
constexpr std::size_t leastKept = std::size_t{1}
                                  << 16;                ///< the allocator keeps smaller ones itself
constexpr std::size_t mostKept = std::size_t{1} << 28;  ///< of all together: two of 4K with floats

struct Block {
  void* data;
  std::size_t bytes;
};

/// The blocks that nobody uses, the oldest first.
struct Pool {
  std::mutex mutex;
  std::vector<Block> blocks;
  std::size_t bytes = 0;
};

/// Returns the pool. It is never destroyed: Python frees arrays after the end of main().
Pool& pool() {
  static Pool* const thePool = new Pool;  // NOLINT: kept
  return *thePool;
}

void* takeFromPool(std::size_t bytes) {
  // A process that was forked meanwhile would wait for ever.
  const std::unique_lock lock(pool().mutex, std::try_to_lock);
  if (!lock) return nullptr;
  auto& blocks = pool().blocks;
  const auto found =
      std::ranges::find_if(blocks, [&](const Block& block) { return block.bytes == bytes; });
  if (found == blocks.end()) return nullptr;
  void* const data = found->data;
  blocks.erase(found);
  pool().bytes -= bytes;
  return data;
}

void putIntoPool(Block block) {
  const std::unique_lock lock(pool().mutex, std::try_to_lock);
  if (!lock || block.bytes < leastKept || block.bytes > mostKept) return std::free(block.data);
  auto& blocks = pool().blocks;
  blocks.push_back(block);
  pool().bytes += block.bytes;
  while (pool().bytes > mostKept) {
    pool().bytes -= blocks.front().bytes;
    std::free(blocks.front().data);
    blocks.erase(blocks.begin());
  }
}

}  // namespace

PictureMemory::PictureMemory(std::size_t bytes) {
  const std::size_t unit = bytes < hugePage ? 64 : hugePage;
  m_bytes = std::max((bytes + unit - 1) / unit, std::size_t{1}) * unit;
  m_data = takeFromPool(m_bytes);
  if (m_data != nullptr) return;
  m_data = std::aligned_alloc(unit, m_bytes);
  if (m_data == nullptr) throw std::bad_alloc();
  if (unit == hugePage) ::madvise(m_data, m_bytes, MADV_HUGEPAGE);  // a wish
}

PictureMemory::~PictureMemory() {
  if (m_data != nullptr) putIntoPool({m_data, m_bytes});
}

}  // namespace hogelscope
