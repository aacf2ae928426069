// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/big_tiff.h"

#include <array>
#include <bit>
#include <cstring>
#include <map>

#include "core/base/error.h"

namespace hogelscope {

static_assert(std::endian::native == std::endian::little, "the file is written as memory is");

namespace {

enum Tag : std::uint16_t {
  imageWidth = 256,
  imageLength = 257,
  bitsPerSample = 258,
  compression = 259,
  photometric = 262,
  imageDescription = 270,
  samplesPerPixel = 277,
  planarConfiguration = 284,
  pageName = 285,
  tileWidth = 322,
  tileLength = 323,
  tileOffsets = 324,
  tileByteCounts = 325,
  sampleFormat = 339,
};

enum FieldType : std::uint16_t { ascii = 2, shortInt = 3, longInt = 4, longInt8 = 16 };

constexpr std::uint16_t zstdCompression = 50000;
constexpr std::uint16_t rgbPhotometric = 2;
constexpr std::size_t entryBytes = 20;
constexpr std::size_t inlineBytes = 8;  ///< values up to this size are stored in the entry
constexpr std::array<char, 8> magic{'I', 'I', 43, 0, 8, 0, 0, 0};
constexpr std::uint64_t longestText = 1U << 20U;

std::size_t fieldBytes(std::uint16_t type) {
  return type == ascii ? 1 : type == shortInt ? 2 : type == longInt ? 4 : type == longInt8 ? 8 : 0;
}

template <class T>
void put(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// A directory under construction: small values in it, large ones before it.
class DirectoryWriter {
 public:
  explicit DirectoryWriter(std::uint64_t at) : m_at(at) {}

  void add(Tag tag, FieldType type, std::uint64_t count, const void* values) {
    std::string bytes(static_cast<const char*>(values), count * fieldBytes(type));
    put(m_entries, static_cast<std::uint16_t>(tag));
    put(m_entries, static_cast<std::uint16_t>(type));
    put(m_entries, count);
    if (bytes.size() <= inlineBytes) {
      bytes.resize(inlineBytes);
      m_entries += bytes;
    } else {
      put(m_entries, m_at + m_large.size());
      m_large += bytes;
      m_large.resize((m_large.size() + 7) / 8 * 8);
    }
    ++m_count;
  }
  void add(Tag tag, std::uint16_t value) { add(tag, shortInt, 1, &value); }
  void add(Tag tag, std::uint32_t value) { add(tag, longInt, 1, &value); }
  void addText(Tag tag, const std::string& text) {
    if (!text.empty()) add(tag, ascii, text.size() + 1, text.c_str());
  }
  void addForEachChannel(Tag tag, std::uint16_t value) {
    const std::array values{value, value, value};
    add(tag, shortInt, values.size(), values.data());
  }

  [[nodiscard]] EncodedPage finished() const {
    EncodedPage page{m_large, m_at + m_large.size()};
    put(page.bytes, m_count);
    page.bytes += m_entries;
    put(page.bytes, std::uint64_t{0});
    return page;
  }

 private:
  std::uint64_t m_at;
  std::uint64_t m_count = 0;
  std::string m_large;
  std::string m_entries;
};

struct Entry {
  std::uint16_t type = 0;
  std::uint64_t count = 0;
  std::uint64_t valueAt = 0;
};

/// Reads the directory at a position.
class DirectoryReader {
 public:
  DirectoryReader(const RandomAccessFile& file, std::uint64_t at) : m_file(file) {
    constexpr std::uint64_t most = 64;
    const auto count = valueAt<std::uint64_t>(at);
    if (count > most) refuse();
    at += sizeof(count);
    for (std::uint64_t k = 0; k < count; ++k, at += entryBytes) {
      Entry entry{valueAt<std::uint16_t>(at + 2), valueAt<std::uint64_t>(at + 4), at + 12};
      const std::uint64_t size = fieldBytes(entry.type);
      if (size > 0 && entry.count > file.size() / size) refuse();
      if (entry.count * size > inlineBytes) entry.valueAt = valueAt<std::uint64_t>(at + 12);
      if (entry.valueAt > file.size() || entry.count * size > file.size() - entry.valueAt) refuse();
      m_entries[valueAt<std::uint16_t>(at)] = entry;
    }
    m_link = {valueAt<std::uint64_t>(at), at};
  }

  [[nodiscard]] const TiffLink& link() const { return m_link; }

  [[noreturn]] void refuse() const {
    throw InputError(m_file.path().string(), "is damaged", "a page of it is not a store's");
  }

  /// Returns the entry of a tag, whose count must be `count` (0: any).
  [[nodiscard]] Entry entry(Tag tag, FieldType type, std::uint64_t count) const {
    const auto found = m_entries.find(tag);
    if (found == m_entries.end() || found->second.type != type ||
        (count > 0 && found->second.count != count))
      refuse();
    return found->second;
  }

  [[nodiscard]] std::uint32_t number(Tag tag, FieldType type, std::uint64_t count = 1) const {
    const Entry found = entry(tag, type, count);
    return type == shortInt ? valueAt<std::uint16_t>(found.valueAt)
                            : valueAt<std::uint32_t>(found.valueAt);
  }

  void require(Tag tag, FieldType type, std::uint32_t value) const {
    if (number(tag, type) != value) refuse();
  }

  /// Returns a text, empty if there is none.
  [[nodiscard]] std::string text(Tag tag) const {
    const auto found = m_entries.find(tag);
    if (found == m_entries.end()) return {};
    if (found->second.type != ascii || found->second.count > longestText) refuse();
    std::string text(found->second.count, '\0');
    m_file.read(found->second.valueAt, std::as_writable_bytes(std::span(text)));
    return text.substr(0, text.find('\0'));
  }

 private:
  template <class T>
  [[nodiscard]] T valueAt(std::uint64_t at) const {
    T value{};
    m_file.read(at, std::as_writable_bytes(std::span(&value, 1)));
    return value;
  }

  const RandomAccessFile& m_file;
  std::map<std::uint16_t, Entry> m_entries;
  TiffLink m_link;
};

StoredType typeOf(const DirectoryReader& directory) {
  constexpr std::uint64_t channels = 3;
  const std::uint32_t bits = directory.number(bitsPerSample, shortInt, channels);
  const std::uint32_t format = directory.number(sampleFormat, shortInt, channels);
  if (bits == 8 && format == 1) return StoredType::uint8;
  if (bits == 16 && format == 1) return StoredType::uint16;
  if (bits == 32 && format == 3) return StoredType::real;
  directory.refuse();
}

}  // namespace

std::string tiffHeader() {
  std::string header(magic.data(), magic.size());
  put(header, std::uint64_t{0});
  return header;
}

EncodedPage encodedPage(const TiffPage& page, const std::vector<std::uint64_t>& offsets,
                        const std::vector<std::uint32_t>& counts, const PageTexts& texts,
                        std::uint64_t at) {
  const bool isReal = page.type == StoredType::real;
  DirectoryWriter directory(at);  // tags in ascending order
  directory.add(imageWidth, page.tilesAcross * tileSide);
  directory.add(imageLength, page.tilesDown * tileSide);
  directory.addForEachChannel(bitsPerSample, std::uint16_t(pixelBytes(page.type) * 8 / 3));
  directory.add(compression, zstdCompression);
  directory.add(photometric, rgbPhotometric);
  directory.addText(imageDescription, texts.description);
  directory.add(samplesPerPixel, std::uint16_t{3});
  directory.add(planarConfiguration, std::uint16_t{1});
  directory.addText(pageName, texts.name);
  directory.add(tileWidth, tileSide);
  directory.add(tileLength, tileSide);
  directory.add(tileOffsets, longInt8, offsets.size(), offsets.data());
  directory.add(tileByteCounts, longInt, counts.size(), counts.data());
  directory.addForEachChannel(sampleFormat, isReal ? 3 : 1);
  return directory.finished();
}

TiffLink firstLink(const RandomAccessFile& file) {
  std::array<char, 16> header{};
  const auto bytes = std::as_writable_bytes(std::span(header));
  TiffLink link{0, firstLinkAt};
  if (file.readSome(0, bytes) == bytes.size() &&
      std::memcmp(header.data(), magic.data(), magic.size()) == 0)
    std::memcpy(&link.next, &header[firstLinkAt], sizeof(link.next));
  return link;
}

DecodedPage readPage(const RandomAccessFile& file, std::uint64_t directoryAt) {
  const DirectoryReader directory(file, directoryAt);
  directory.require(compression, shortInt, zstdCompression);
  directory.require(photometric, shortInt, rgbPhotometric);
  directory.require(samplesPerPixel, shortInt, 3);
  directory.require(planarConfiguration, shortInt, 1);
  directory.require(tileWidth, longInt, tileSide);
  directory.require(tileLength, longInt, tileSide);
  DecodedPage result;
  result.page.tilesAcross = directory.number(imageWidth, longInt) / tileSide;
  result.page.tilesDown = directory.number(imageLength, longInt) / tileSide;
  result.page.type = typeOf(directory);
  const std::uint64_t tiles = result.page.tiles();
  if (tiles == 0) directory.refuse();
  result.page.offsetsAt = directory.entry(tileOffsets, longInt8, tiles).valueAt;
  result.page.countsAt = directory.entry(tileByteCounts, longInt, tiles).valueAt;
  result.texts = {directory.text(imageDescription), directory.text(pageName)};
  result.link = directory.link();
  // Pages of this program have ascending positions; a backward link would form a loop.
  if (result.link.next != 0 && result.link.next <= directoryAt) directory.refuse();
  return result;
}

}  // namespace hogelscope
