// SPDX-License-Identifier: BSD-3-Clause
#include "io/store/light_field_store.h"

#include <algorithm>
#include <thread>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "io/store/block_cache.h"
#include "io/store/tile_codec.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Returns the number of blocks that a thread takes at a time.
std::size_t pieceOf(std::size_t count, int threads) {
  constexpr std::size_t most = 256;
  return std::clamp<std::size_t>(count / (8 * std::size_t(threads)), 1, most);
}

}  // namespace

/// A thread's access to the tiles: its decoder, its row of the index, and the part of the file read
/// ahead.
class LightFieldStore::Reader {
 public:
  explicit Reader(const RandomAccessFile& file) : m_file(file) {}

  BlockTexels own;  ///< the block it decoded last

  /// Decodes the tile. Returns "" or the reason of a failure.
  std::string read(const TiffPage& page, std::uint32_t column, std::uint32_t row,
                   std::span<std::byte> tile) {
    loadRow(page, row);
    const std::uint64_t at = m_offsets[column];
    const std::uint32_t count = m_counts[column];
    if (at > m_file.size() || count > m_file.size() - at) return "it lies beyond the file's end";
    return decompressTile(bytesAt(at, count), tile);
  }

 private:
  void loadRow(const TiffPage& page, std::uint32_t row) {
    if (m_rowOf == page.offsetsAt && m_row == row && !m_offsets.empty()) return;
    m_offsets.resize(page.tilesAcross);
    m_counts.resize(page.tilesAcross);
    const std::uint64_t first = std::uint64_t(row) * page.tilesAcross;
    m_file.read(page.offsetsAt + first * sizeof(m_offsets[0]),
                std::as_writable_bytes(std::span(m_offsets)));
    m_file.read(page.countsAt + first * sizeof(m_counts[0]),
                std::as_writable_bytes(std::span(m_counts)));
    m_rowOf = page.offsetsAt;
    m_row = row;
  }

  /// Returns bytes of the file and reads ahead, because neighbouring tiles are adjacent and most
  /// have a hundred bytes.
  std::span<const std::byte> bytesAt(std::uint64_t at, std::uint32_t count) {
    constexpr std::size_t ahead = 4096;
    if (at < m_bytesAt || at + count > m_bytesAt + m_bytes.size()) {
      m_bytes.resize(std::max<std::size_t>(count, ahead));
      m_bytes.resize(m_file.readSome(at, m_bytes));
      m_bytesAt = at;
    }
    // A file that has become shorter gives fewer bytes, which fail to decompress.
    const std::size_t from = std::min<std::size_t>(at - m_bytesAt, m_bytes.size());
    return std::span(m_bytes).subspan(from, std::min<std::size_t>(count, m_bytes.size() - from));
  }

  const RandomAccessFile& m_file;
  std::uint64_t m_rowOf = 0;
  std::uint32_t m_row = 0;
  std::vector<std::uint64_t> m_offsets;
  std::vector<std::uint32_t> m_counts;
  std::uint64_t m_bytesAt = 0;
  std::vector<std::byte> m_bytes;
};

LightFieldStore::LightFieldStore(const fs::path& file, bool incoming, std::size_t cacheBytes,
                                 int threads)
    : m_file(file),
      m_incoming(incoming),
      m_threads(threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency()))) {
  inFile(file.string(), [this] { openPages(); });
  if (cacheBytes > 0)
    m_cache = std::make_unique<BlockCache>(cacheBytes, m_pages.front().tileBytes());
}

LightFieldStore::~LightFieldStore() = default;

bool LightFieldStore::isStore(const fs::path& path) {
  std::error_code none;
  if (!fs::is_regular_file(path, none)) return false;
  try {
    const RandomAccessFile file(path);
    const TiffLink link = firstLink(file);
    return link.next != 0 &&
           parseStoreHeader(readPage(file, link.next).texts.description).has_value();
  } catch (const InputError&) {
    return false;
  }
}

void LightFieldStore::openPages() {
  TiffLink link = firstLink(m_file);
  if (link.next == 0) throw InputError("", "is not a Hogelscope store");
  const DecodedPage first = readPage(m_file, link.next);
  const std::optional<StoreHeader> header = parseStoreHeader(first.texts.description);
  if (!header) throw InputError("", "is a TIFF, but not a Hogelscope store");
  m_header = *header;
  const int wanted = m_header.blocks().j + 1;
  StoreHeader content = m_header;
  content.source.clear();
  content.display.reset();
  ContentHash hash;
  const auto add = [&hash](const std::string& text) { hash.add(std::as_bytes(std::span(text))); };
  add(textOf(content));
  bool hasAll = true;
  while (link.next != 0 && int(m_pages.size()) < wanted) {
    const DecodedPage page = readPage(m_file, link.next);
    checkPage(int(m_pages.size()), page.page);
    m_pages.push_back(page.page);
    hasAll = hasAll && isPageName(page.texts.name);
    add(page.texts.name);
    link = page.link;
  }
  if (int(m_pages.size()) < wanted)
    throw InputError("", "is not complete: it has " + std::to_string(m_pages.size()) + " of " +
                             std::to_string(wanted) + " pages");
  if (hasAll) m_contentHash = hash.hex();
}

void LightFieldStore::checkPage(int number, const TiffPage& page) const {
  const BlockIndex blocks = m_header.blocks();
  const bool isOverview = number == blocks.j;
  const std::size_t across = isOverview ? tilesAlong(m_header.overview.width())
                                        : std::size_t(blocks.i) * std::size_t(blocks.u);
  const std::size_t down =
      isOverview ? tilesAlong(m_header.overview.height()) : std::size_t(blocks.v);
  if (page.tilesAcross != across || page.tilesDown != down || page.type != m_header.type)
    throw InputError("page " + std::to_string(number), "is not as the store's description says");
}

void LightFieldStore::decode(Reader& reader, const BlockIndex& at,
                             std::span<std::byte> texels) const {
  const auto column = std::uint32_t(at.i * m_header.blocks().u + at.u);
  const std::string wrong =
      reader.read(m_pages[std::size_t(at.j)], column, std::uint32_t(at.v), texels);
  if (!wrong.empty())
    throw InputError(m_file.path().string(),
                     "page " + std::to_string(at.j) + ", tile (" + std::to_string(column) + ", " +
                         std::to_string(at.v) + ")",
                     "is damaged: " + wrong);
}

void LightFieldStore::blocks(std::span<const BlockIndex> wanted, const BlockUse& use,
                             const Progress& progress) const {
  const BlockIndex counts = m_header.blocks();
  const std::size_t bytes = m_pages.front().tileBytes();
  const auto keyOf = [&](const BlockIndex& at) {
    const auto row = std::uint64_t(at.j) * std::uint64_t(counts.v) + std::uint64_t(at.v);
    const auto column = std::uint64_t(at.i) * std::uint64_t(counts.u) + std::uint64_t(at.u);
    return row * m_pages.front().tilesAcross + column;
  };
  const auto decoded = [&](Reader& reader, const BlockIndex& at) {
    const std::uint64_t key = keyOf(at);
    if (m_cache)
      if (BlockTexels found = m_cache->find(key)) return found;
    if (m_cache || !reader.own) reader.own = std::make_shared_for_overwrite<std::byte[]>(bytes);
    decode(reader, at, {reader.own.get(), bytes});
    if (m_cache) m_cache->put(key, reader.own);
    return reader.own;
  };
  const std::size_t piece = pieceOf(wanted.size(), m_threads);
  const std::size_t pieces = (wanted.size() + piece - 1) / piece;
  std::vector<Reader> readers;
  while (readers.size() < std::clamp<std::size_t>(pieces, 1, std::size_t(m_threads)))
    readers.emplace_back(m_file);
  throwIfCancelled(progress);  // the other threads may have left no blocks for this one
  sideBySide(pieces, int(readers.size()), [&](std::size_t k, std::size_t worker) {
    if (worker == 0) reportProgress(progress, double(k) / double(pieces));
    const std::size_t end = std::min((k + 1) * piece, wanted.size());
    for (std::size_t at = k * piece; at < end; ++at)
      use(at, {decoded(readers[worker], wanted[at]).get(), bytes});
  });
}

std::shared_ptr<const LightField> LightFieldStore::overview() const {
  std::call_once(m_overviewIsRead,
                 [this] { m_overview = std::make_shared<const LightField>(readOverview()); });
  return m_overview;
}

LightField LightFieldStore::readOverview() const {
  const LightFieldSize& size = m_header.overview;
  const TiffPage& page = m_pages.back();
  LightField target(size, m_header.type);
  Reader reader(m_file);
  std::vector<std::byte> tile(page.tileBytes());
  for (std::uint32_t row = 0; row < page.tilesDown; ++row)
    for (std::uint32_t column = 0; column < page.tilesAcross; ++column) {
      const std::string wrong = reader.read(page, column, row, tile);
      if (!wrong.empty())
        throw InputError(m_file.path().string(), "overview", "is damaged: " + wrong);
      placeOverview(int(column * tileSide), int(row * tileSide), tile, target);
    }
  return target;
}

}  // namespace hogelscope
