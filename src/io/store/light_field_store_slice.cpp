// SPDX-License-Identifier: BSD-3-Clause
// Reads a view's slice of a store: the blocks in its footprint.
#include <algorithm>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/system_limits.h"
#include "io/store/light_field_store.h"
#include "io/store/tile_codec.h"

namespace hogelscope {

namespace {

/// Returns the blocks of directions that cells [cell, cell + count) need, in ascending order.
std::vector<int> neededBlocks(const std::vector<CellRange>& ranges, int cell, int count,
                              int blockCells) {
  std::vector<int> needed;
  const int end = std::min(cell + count, int(ranges.size()));
  for (int k = cell; k < end; ++k) {
    const CellRange& range = ranges[std::size_t(k)];
    if (range.isEmpty()) continue;
    for (int block = range.first / blockCells; block <= range.last / blockCells; ++block)
      needed.push_back(block);
  }
  std::sort(needed.begin(), needed.end());
  needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
  return needed;
}

std::vector<BlockIndex> blocksOf(const StoreHeader& header, const Footprint& footprint) {
  const BlockIndex counts = header.blocks();
  const auto& [bi, bj, bu, bv] = header.block;
  std::vector<std::vector<int>> ofColumn(std::size_t(counts.i));
  for (int i = 0; i < counts.i; ++i)
    ofColumn[std::size_t(i)] = neededBlocks(footprint.u, i * bi, bi, bu);
  std::vector<BlockIndex> blocks;
  for (int j = 0; j < counts.j; ++j)
    for (const int v : neededBlocks(footprint.v, j * bj, bj, bv))
      for (int i = 0; i < counts.i; ++i)
        for (const int u : ofColumn[std::size_t(i)]) blocks.push_back({i, j, u, v});
  return blocks;
}

/// Returns the part of a cell's directions that lies in a block, counted from the block's first.
CellRange within(const CellRange& range, int block, int blockCells) {
  return {std::max(range.first - block * blockCells, 0),
          std::min(range.last - block * blockCells, blockCells - 1)};
}

/// Returns the same for the hogels of a block along one axis.
std::vector<CellRange> within(const std::vector<CellRange>& ranges, int cell, int count, int block,
                              int blockCells) {
  std::vector<CellRange> result;
  for (int k = cell; k < std::min(cell + count, int(ranges.size())); ++k)
    result.push_back(within(ranges[std::size_t(k)], block, blockCells));
  return result;
}

}  // namespace

/// Returns the footprint in the file's own directions.
Footprint LightFieldStore::stored(const Footprint& footprint) const {
  Footprint result = footprint;
  if (!m_incoming) return result;
  const auto turn = [](std::vector<CellRange>& ranges, int count) {
    for (CellRange& range : ranges)
      if (!range.isEmpty()) range = {count - 1 - range.last, count - 1 - range.first};
  };
  turn(result.u, m_header.size.du);
  turn(result.v, m_header.size.dv);
  return result;
}

std::shared_ptr<const LightFieldSource> LightFieldStore::source(const SourceUse& use,
                                                                const Progress& progress) {
  if (fitsInMemory(*this, use.memory)) return LightFieldFile::source(use, progress);
  return std::make_shared<const LightFieldStore>(m_file.path(), m_incoming,
                                                 std::min(use.memory, use.cache), use.threads);
}

std::shared_ptr<const LightField> LightFieldStore::slice(const ViewReads& reads,
                                                         const Progress& progress) const {
  const Footprint footprint = reads.footprint();
  if (auto last = lastSlice(); last && last->covers(footprint)) return last;
  requireMemory(footprint, memoryBytes(m_header.type), allowedMemory());
  auto target = std::make_shared<LightField>(m_header.size, m_header.type, sliceLayout(footprint));
  const Footprint inFile = stored(footprint);
  const std::vector<BlockIndex> wanted = blocksOf(m_header, inFile);
  blocks(
      wanted,
      [&](std::size_t k, std::span<const std::byte> texels) {
        placeSlice(wanted[k], texels, inFile, *target);
      },
      progress);
  // A single texel's slice does not replace that of a view.
  constexpr std::size_t leastOfView = std::size_t{1} << 20;
  if (footprint.texels() >= leastOfView) {
    const std::lock_guard lock(m_sliceMutex);
    m_lastSlice = target;
  }
  return target;
}

std::shared_ptr<const LightField> LightFieldStore::lastSlice() const {
  const std::lock_guard lock(m_sliceMutex);
  return m_lastSlice;
}

void LightFieldStore::placeSlice(const BlockIndex& block, std::span<const std::byte> texels,
                                 const Footprint& footprint, LightField& target) const {
  const auto& [bi, bj, bu, bv] = m_header.block;
  const int i0 = block.i * bi;
  const int j0 = block.j * bj;
  const std::vector<CellRange> columns = within(footprint.u, i0, bi, block.u, bu);
  const std::vector<CellRange> rows = within(footprint.v, j0, bj, block.v, bv);
  const auto put = [&, bu = bu, bv = bv](int i, int j, const CellRange& u, int v, const auto* rgb) {
    TexelIndex at{i0 + i, j0 + j, block.u * bu + u.first, block.v * bv + v};
    if (!m_incoming) return target.setRun(at, int(u.size()), rgb);
    at = {at.i, at.j, m_header.size.du - 1 - at.u, m_header.size.dv - 1 - at.v};
    for (int k = u.first; k <= u.last; ++k, --at.u, rgb += 3) target.set(at, rgb);
  };
  const auto putAll = [&, bu = bu, bv = bv](const auto* values) {
    for (int j = 0; j < int(rows.size()); ++j)
      for (int v = rows[std::size_t(j)].first; v <= rows[std::size_t(j)].last; ++v)
        for (int i = 0; i < int(columns.size()); ++i) {
          const CellRange& u = columns[std::size_t(i)];
          if (u.isEmpty()) continue;
          put(i, j, u, v,
              values + 3 * (std::size_t(j * bv + v) * tileSide + std::size_t(i * bu + u.first)));
        }
  };
  withStoredType(m_header.type, [&](auto zero) {
    putAll(reinterpret_cast<const decltype(zero)*>(texels.data()));
  });
}

}  // namespace hogelscope
