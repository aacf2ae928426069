// SPDX-License-Identifier: BSD-3-Clause
#include "io/store/tile_codec.h"

#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace hogelscope {

namespace {

constexpr int level = 1;

/// Copies the directions of each hogel. `piece` is the usual block's size as a constant, which
/// avoids a call for copying.
template <std::size_t piece>
void copyHogels(const std::byte* from, std::size_t stride, int hogels, std::byte* to) {
  for (int k = 0; k < hogels; ++k)
    std::memcpy(to + std::size_t(k) * piece, from + std::size_t(k) * stride, piece);
}

void copyHogels(const std::byte* from, std::size_t stride, const BlockCut& cut, std::size_t texel,
                std::size_t blockBytes, std::byte* to) {
  const std::size_t bytes = std::size_t(cut.directions) * texel;
  if (bytes == 24 && blockBytes == 24) return copyHogels<24>(from, stride, cut.hogels, to);
  if (bytes == 48 && blockBytes == 48) return copyHogels<48>(from, stride, cut.hogels, to);
  if (bytes == 96 && blockBytes == 96) return copyHogels<96>(from, stride, cut.hogels, to);
  for (int k = 0; k < cut.hogels; ++k)
    std::memcpy(to + std::size_t(k) * blockBytes, from + std::size_t(k) * stride, bytes);
}

bool isUniform(std::span<const std::byte> tile, std::size_t texel) {
  return std::memcmp(tile.data(), tile.data() + texel, tile.size() - texel) == 0;
}

bool isBlack(std::span<const std::byte> texel) {
  return std::all_of(texel.begin(), texel.end(), [](std::byte b) { return b == std::byte{0}; });
}

}  // namespace

void gatherBlock(const StoreHeader& header, const BlockCut& cut,
                 std::span<const std::byte* const> rows, std::span<std::byte> tile) {
  const std::size_t texel = pixelBytes(header.type);
  const std::size_t rowBytes = tileSide * texel;
  const std::size_t stride = std::size_t(header.size.du) * texel;
  const bool isWhole = cut.hogels == header.block.i && cut.directions == header.block.u;
  std::byte* to = tile.data();
  for (const std::byte* row : rows) {
    if (row == nullptr || !isWhole) std::memset(to, 0, rowBytes);
    if (row != nullptr)
      copyHogels(row + std::size_t(cut.i) * stride + std::size_t(cut.u) * texel, stride, cut, texel,
                 std::size_t(header.block.u) * texel, to);
    to += rowBytes;
  }
}

TileCompressor::TileCompressor(StoredType type)
    : m_pixelBytes(pixelBytes(type)), m_context(ZSTD_createCCtx(), &ZSTD_freeCCtx) {
  if (!m_context) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(m_context.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(m_context.get(), ZSTD_c_checksumFlag, 1);  // to detect damage
}

void TileCompressor::compress(std::span<const std::byte> tile) {
  m_compressed.resize(ZSTD_compressBound(tile.size()));
  const std::size_t bytes = ZSTD_compress2(m_context.get(), m_compressed.data(),
                                           m_compressed.size(), tile.data(), tile.size());
  if (ZSTD_isError(bytes) != 0) throw std::runtime_error(ZSTD_getErrorName(bytes));
  m_compressed.resize(bytes);
}

void TileCompressor::add(std::span<const std::byte> tile, TileBytes& out) {
  const auto put = [&out](const std::vector<std::byte>& bytes) {
    out.bytes.insert(out.bytes.end(), bytes.begin(), bytes.end());
    out.counts.push_back(std::uint32_t(bytes.size()));
  };
  if (!isUniform(tile, m_pixelBytes)) {
    compress(tile);
    return put(m_compressed);
  }
  const auto colour = tile.first(m_pixelBytes);
  const bool isBlackTile = isBlack(colour);
  if (isBlackTile && !out.black.empty()) return out.counts.push_back(0);
  if (!std::equal(colour.begin(), colour.end(), m_uniform.begin(), m_uniform.end())) {
    m_uniform.assign(colour.begin(), colour.end());
    compress(tile);
    m_ofUniform = m_compressed;
  }
  if (!isBlackTile) return put(m_ofUniform);
  out.black = m_ofUniform;
  out.counts.push_back(0);
}

std::string decompressTile(std::span<const std::byte> bytes, std::span<std::byte> tile) {
  // Of each thread: a view reads many slices, and making contexts took a seventh of an export.
  thread_local const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(
      ZSTD_createDCtx(), &ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  const std::size_t got =
      ZSTD_decompressDCtx(context.get(), tile.data(), tile.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(got) != 0) return ZSTD_getErrorName(got);
  return got == tile.size() ? "" : "it has another size";
}

}  // namespace hogelscope
