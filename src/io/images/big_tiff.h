// SPDX-License-Identifier: BSD-3-Clause
// Pages of BigTIFF files of this program: tiles of 64×64 RGB pixels, each compressed with zstd. Any
// reader with zstd (libtiff, GDAL, OpenImageIO) can read them. This reader reads the tiles' index
// in place, row by row, because a whole index can be 280 MB. It does not use libtiff, so that any
// thread can read tiles by position.
#pragma once

#include <string>

#include "core/light_field/light_field.h"
#include "io/files/random_access_file.h"

namespace hogelscope {

inline constexpr std::uint32_t tileSide = 64;  ///< px
constexpr std::uint32_t tilesAlong(std::size_t pixels) {
  return std::uint32_t((pixels + tileSide - 1) / tileSide);
}

struct TiffPage {
  std::uint32_t tilesAcross = 0;
  std::uint32_t tilesDown = 0;
  StoredType type = StoredType::uint8;
  std::uint64_t offsetsAt = 0;  ///< file position of the tiles' offsets, 64 bits each
  std::uint64_t countsAt = 0;   ///< file position of their byte counts, 32 bits each

  [[nodiscard]] std::uint64_t tiles() const { return std::uint64_t(tilesAcross) * tilesDown; }
  [[nodiscard]] std::size_t tileBytes() const {
    return std::size_t(tileSide) * tileSide * pixelBytes(type);
  }
};

/// A link in the chain of pages.
struct TiffLink {
  std::uint64_t next = 0;    ///< position of the next page's directory, 0: none
  std::uint64_t nextAt = 0;  ///< file position of `next`
};

/// Returns the file's first bytes, with its link at `firstLinkAt`.
std::string tiffHeader();
inline constexpr std::uint64_t firstLinkAt = 8;

struct PageTexts {
  std::string description;
  std::string name;
};

/// Index, texts and directory encoded for the file position `at`. `offsets` and `counts` are those
/// of the tiles, row by row; the directory comes last, with its link in the last 8 bytes.
struct EncodedPage {
  std::string bytes;
  std::uint64_t directoryAt = 0;
};
EncodedPage encodedPage(const TiffPage& page, const std::vector<std::uint64_t>& offsets,
                        const std::vector<std::uint32_t>& counts, const PageTexts& texts,
                        std::uint64_t at);

/// Returns the first page's link; `next` is 0 if the file is not a BigTIFF of this program.
TiffLink firstLink(const RandomAccessFile& file);

/// A page read from a file. Reading throws InputError for a page that this program cannot have
/// written.
struct DecodedPage {
  TiffPage page;
  PageTexts texts;
  TiffLink link;
};
DecodedPage readPage(const RandomAccessFile& file, std::uint64_t directoryAt);

}  // namespace hogelscope
