// SPDX-License-Identifier: BSD-3-Clause
#include "io/store/band_packer.h"

#include <algorithm>
#include <chrono>
#include <cstring>

namespace hogelscope {

std::size_t BandPacker::bandRows(const StoreHeader& header) {
  return std::size_t(std::min(header.block.j, header.size.ny)) * std::size_t(header.size.dv);
}

BandPacker::BandPacker(const StoreHeader& header, std::size_t rows, int threads,
                       StoreOutput& output)
    : m_header(header),
      m_blocks(header.blocks()),
      m_output(output),
      m_rowBytes(header.size.width() * pixelBytes(header.type)),
      m_firstPage(output.pages()),
      m_memory(std::make_unique_for_overwrite<std::byte[]>(rows * m_rowBytes)),
      m_turn(long(m_firstPage) * m_blocks.v) {
  for (std::size_t k = rows; k-- > 0;) m_free.push_back(&m_memory[k * m_rowBytes]);
  try {
    for (int k = 0; k < threads; ++k) m_threads.emplace_back([this] { work(); });
  } catch (const std::system_error&) {  // the machine allows no more threads; the existing ones do
                                        // all the work
    if (m_threads.empty()) throw;
  }
}

BandPacker::~BandPacker() {
  stop();
}

void BandPacker::stop() {
  {
    const std::lock_guard lock(m_mutex);
    m_isStopped = true;
  }
  m_changed.notify_all();
  m_threads.clear();  // joins the threads
}

std::byte* BandPacker::freeRow() {
  std::unique_lock lock(m_mutex);
  m_changed.wait(lock, [this] { return !m_free.empty() || m_error; });
  if (m_error) std::rethrow_exception(m_error);
  std::byte* row = m_free.back();
  m_free.pop_back();
  return row;
}

void BandPacker::take(int j, int v, const void* rgb) {
  const int page = j / m_header.block.j;
  if (page < m_firstPage) return;
  const auto dv = std::size_t(m_header.size.dv);
  const int hogels = std::min(m_header.block.j, m_header.size.ny - page * m_header.block.j);
  if (!m_filling) {
    m_filling = std::make_shared<Band>();
    m_filling->page = page;
    m_filling->rows.resize(std::size_t(hogels) * dv);
  }
  std::byte* row = freeRow();
  std::memcpy(row, rgb, m_rowBytes);
  m_filling->rows[std::size_t(j % m_header.block.j) * dv + std::size_t(v)] = row;
  if (++m_filling->taken < m_filling->rows.size()) return;
  {
    const std::lock_guard lock(m_mutex);
    m_full.push_back(std::move(m_filling));
  }
  m_filling = nullptr;
  m_changed.notify_all();
}

void BandPacker::finish(const Progress& progress) {
  const long all = long(m_blocks.j) * m_blocks.v;
  std::unique_lock lock(m_mutex);
  m_isAllTaken = true;
  m_changed.notify_all();
  while (m_turn < all && !m_error) {
    constexpr std::chrono::milliseconds step(100);
    m_changed.wait_for(lock, step);
    reportProgress(progress, double(m_turn) / double(all));
  }
  if (m_error) std::rethrow_exception(m_error);
}

std::optional<BandPacker::Strip> BandPacker::nextStrip() {
  std::unique_lock lock(m_mutex);
  m_changed.wait(lock,
                 [this] { return m_isStopped || m_error || m_isAllTaken || !m_full.empty(); });
  if (m_isStopped || m_error || m_full.empty()) return std::nullopt;
  Strip strip{m_full.front(), m_full.front()->strips++};
  if (strip.band->strips == m_blocks.v) m_full.pop_front();
  return strip;
}

void BandPacker::work() {
  try {
    TileCompressor compressor(m_header.type);
    while (const std::optional<Strip> strip = nextStrip()) {
      const TileBytes tiles = compressed(*strip, compressor);
      write(*strip, tiles);
      release(*strip);  // last, so that waiting tiles never exceed the rows they came from
    }
  } catch (...) {
    const std::lock_guard lock(m_mutex);
    if (!m_error) m_error = std::current_exception();
    m_changed.notify_all();
  }
}

/// Returns the rows of each row of the strip's tiles; null beyond the light field's edge.
std::vector<std::byte*> BandPacker::rowsOf(const Strip& strip) const {
  const auto bv = std::size_t(m_header.block.v);
  const auto dv = std::size_t(m_header.size.dv);
  const std::size_t first = std::size_t(strip.v) * bv;
  std::vector<std::byte*> rows(tileSide, nullptr);
  for (std::size_t j = 0; j < strip.band->rows.size() / dv; ++j)
    for (std::size_t v = 0; v < std::min(bv, dv - first); ++v)
      rows[j * bv + v] = strip.band->rows[j * dv + first + v];
  return rows;
}

TileBytes BandPacker::compressed(const Strip& strip, TileCompressor& compressor) const {
  const auto [bi, bj, bu, bv] = m_header.block;
  const std::vector<std::byte*> rows = rowsOf(strip);
  std::vector<std::byte> tile(std::size_t(tileSide) * tileSide * pixelBytes(m_header.type));
  TileBytes tiles;
  for (int i = 0; i < m_header.size.nx; i += bi)
    for (int u = 0; u < m_header.size.du; u += bu) {
      const BlockCut cut{i, std::min(bi, m_header.size.nx - i), u,
                         std::min(bu, m_header.size.du - u)};
      gatherBlock(m_header, cut, rows, tile);
      compressor.add(tile, tiles);
    }
  return tiles;
}

void BandPacker::release(const Strip& strip) {
  const std::vector<std::byte*> rows = rowsOf(strip);
  {
    const std::lock_guard lock(m_mutex);
    for (std::byte* row : rows)
      if (row != nullptr) m_free.push_back(row);
  }
  m_changed.notify_all();
}

void BandPacker::write(const Strip& strip, const TileBytes& tiles) {
  const long turn = long(strip.band->page) * m_blocks.v + strip.v;
  {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_turn == turn || m_isStopped || m_error; });
    if (m_turn != turn || m_isStopped || m_error) return;
  }
  m_output.add(tiles);
  if (strip.v == m_blocks.v - 1)
    m_output.finishPage(
        {std::uint32_t(m_blocks.i * m_blocks.u), std::uint32_t(m_blocks.v), m_header.type});
  {
    const std::lock_guard lock(m_mutex);
    ++m_turn;
  }
  m_changed.notify_all();
}

}  // namespace hogelscope
