// SPDX-License-Identifier: BSD-3-Clause
// Gathering, compression and decompression of a store's tiles.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "io/store/store_output.h"

struct ZSTD_CCtx_s;

namespace hogelscope {

/// The hogels of a block, starting at `i`, and its directions, starting at `u`; fewer than the
/// block's cells at the light field's edges.
struct BlockCut {
  int i = 0;
  int hogels = 0;
  int u = 0;
  int directions = 0;
};

/// Fills a tile with block `cut`. `rows` are the hogel image's rows for each row of the tile; null
/// beyond the light field's edge.
void gatherBlock(const StoreHeader& header, const BlockCut& cut,
                 std::span<const std::byte* const> rows, std::span<std::byte> tile);

/// Compresses at zstd's fastest level; docs/measurements.md compares others. Not thread-safe.
class TileCompressor {
 public:
  explicit TileCompressor(StoredType type);
  /// Adds a tile to `out`; black ones are written once.
  void add(std::span<const std::byte> tile, TileBytes& out);

 private:
  using Context = std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)>;
  void compress(std::span<const std::byte> tile);

  std::size_t m_pixelBytes;
  Context m_context;
  std::vector<std::byte> m_compressed;
  std::vector<std::byte> m_uniform;  ///< the colour of the tile `m_ofUniform`
  std::vector<std::byte> m_ofUniform;
};

/// Decompresses a tile. Returns "" or the reason of a failure: damaged, or not of the tile's size.
std::string decompressTile(std::span<const std::byte> bytes, std::span<std::byte> tile);

}  // namespace hogelscope
