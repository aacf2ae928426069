// SPDX-License-Identifier: BSD-3-Clause
// Copies a store's blocks to a view's slice, to a light field in memory or to rows of a hogel
// image.
#include <algorithm>
#include <cstring>

#include "core/base/error.h"
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

/// Calls use(texel's index, position of its values in the tile) for the part of a block inside the
/// light field, in its hogel rows [begin, end).
template <class Use>
void forEachTexel(const StoreHeader& header, const BlockIndex& block, int begin, int end, Use use) {
  const auto& [nx, ny, du, dv] = header.size;
  const auto& [bi, bj, bu, bv] = header.block;
  const int i0 = block.i * bi;
  const int j0 = block.j * bj;
  const int u0 = block.u * bu;
  const int v0 = block.v * bv;
  for (int j = begin; j < std::min(end, ny - j0); ++j)
    for (int v = 0; v < std::min(bv, dv - v0); ++v)
      for (int i = 0; i < std::min(bi, nx - i0); ++i)
        for (int u = 0; u < std::min(bu, du - u0); ++u)
          use(TexelIndex{i0 + i, j0 + j, u0 + u, v0 + v},
              std::size_t(j * bv + v) * tileSide + std::size_t(i * bu + u));
}

std::vector<BlockIndex> blocksOfPage(const BlockIndex& counts, int page) {
  std::vector<BlockIndex> all;
  for (int v = 0; v < counts.v; ++v)
    for (int i = 0; i < counts.i; ++i)
      for (int u = 0; u < counts.u; ++u) all.push_back({i, page, u, v});
  return all;
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

void LightFieldStore::copyBlock(const BlockIndex& block, std::span<const std::byte> texels,
                                LightField& target) const {
  withStoredType(m_header.type, [&](auto zero) {
    using T = decltype(zero);
    const auto* values = reinterpret_cast<const T*>(texels.data());
    forEachTexel(m_header, block, 0, m_header.block.j, [&](TexelIndex at, std::size_t texel) {
      if (m_incoming) at = {at.i, at.j, m_header.size.du - 1 - at.u, m_header.size.dv - 1 - at.v};
      target.set(at, values + 3 * texel);
    });
  });
}

void LightFieldStore::placeOverview(int x0, int y0, std::span<const std::byte> texels,
                                    LightField& target) const {
  const LightFieldSize& size = m_header.overview;
  const int columns = std::min(int(tileSide), int(size.width()) - x0);
  const int rows = std::min(int(tileSide), int(size.height()) - y0);
  withStoredType(m_header.type, [&](auto zero) {
    const auto* values = reinterpret_cast<const decltype(zero)*>(texels.data());
    for (int y = y0; y < y0 + rows; ++y)
      for (int x = x0; x < x0 + columns; ++x) {
        TexelIndex at{x / size.du, y / size.dv, x % size.du, y % size.dv};
        if (m_incoming) at = {at.i, at.j, size.du - 1 - at.u, size.dv - 1 - at.v};
        target.set(at, values + 3 * (std::size_t(y - y0) * tileSide + std::size_t(x - x0)));
      }
  });
}

LightField LightFieldStore::read(const Progress& progress) {
  LightField target = blankLightField(m_header.size, m_header.type, m_file.path());
  const BlockIndex counts = m_header.blocks();
  for (int page = 0; page < counts.j; ++page) {
    const std::vector<BlockIndex> wanted = blocksOfPage(counts, page);
    blocks(
        wanted,
        [&](std::size_t k, std::span<const std::byte> texels) {
          copyBlock(wanted[k], texels, target);
        },
        part(progress, double(page) / counts.j, double(page + 1) / counts.j));
  }
  return target;
}

void LightFieldStore::stream(const HogelRow& row, const Progress& progress) {
  const int ny = m_header.size.ny;
  const std::size_t hogelRowBytes =
      m_header.size.width() * std::size_t(m_header.size.dv) * pixelBytes(m_header.type);
  // Blocks are decoded again for each part of their hogel rows.
  const int rows = int(std::clamp<std::size_t>(allowedMemory() / 2 / hogelRowBytes, 1,
                                               std::size_t(m_header.block.j)));
  withStoredType(m_header.type, [&](auto zero) {
    std::vector<decltype(zero)> band;
    for (int j = 0; j < ny;) {
      const int bandEnd = std::min(ny, (j / m_header.block.j + 1) * m_header.block.j);
      const int end = std::min(bandEnd, j + rows);
      readBand(j, end, band, part(progress, double(j) / ny, double(end) / ny));
      const decltype(zero)* rgb = band.data();
      for (; j < end; ++j)
        for (int v = 0; v < m_header.size.dv; ++v, rgb += 3 * m_header.size.width()) row(j, v, rgb);
    }
  });
}

/// Reads hogel rows [begin, end) of a row of blocks.
template <class T>
void LightFieldStore::readBand(int begin, int end, std::vector<T>& band,
                               const Progress& progress) const {
  const auto& [nx, ny, du, dv] = m_header.size;
  const std::size_t width = m_header.size.width();
  band.resize(3 * width * std::size_t(dv) * std::size_t(end - begin));
  const int page = begin / m_header.block.j;
  const int first = page * m_header.block.j;
  const std::vector<BlockIndex> wanted = blocksOfPage(m_header.blocks(), page);
  const auto put = [&, du = du, dv = dv](const TexelIndex& at, const std::byte* values) {
    const int u = m_incoming ? du - 1 - at.u : at.u;
    const int v = m_incoming ? dv - 1 - at.v : at.v;
    const auto y = std::size_t(at.j - begin) * std::size_t(dv) + std::size_t(v);
    const auto x = std::size_t(at.i) * std::size_t(du) + std::size_t(u);
    std::memcpy(&band[3 * (y * width + x)], values, 3 * sizeof(T));
  };
  blocks(
      wanted,
      [&](std::size_t k, std::span<const std::byte> texels) {
        forEachTexel(m_header, wanted[k], begin - first, end - first,
                     [&](const TexelIndex& at, std::size_t texel) {
                       put(at, texels.data() + 3 * sizeof(T) * texel);
                     });
      },
      progress);
}

}  // namespace hogelscope
