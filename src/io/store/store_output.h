// SPDX-License-Identifier: BSD-3-Clause
// Writes a store as FILE.part. A page is linked only when it is completely on disk; however the
// program ends, the next run continues after the last page.
#pragma once

#include <filesystem>

#include "io/files/content_hash.h"
#include "io/images/big_tiff.h"
#include "io/store/store_header.h"

namespace hogelscope {

/// Compressed tiles, in order.
struct TileBytes {
  std::vector<std::byte> bytes;
  std::vector<std::uint32_t> counts;  ///< bytes of each tile; 0: black
  std::vector<std::byte> black;       ///< a compressed black tile, if any
};

class StoreOutput {
 public:
  /// Resumes FILE.part if it has the same header, else restarts it. Throws InputError if it is
  /// another file, another run is writing it, or it cannot be written.
  StoreOutput(const std::filesystem::path& file, const StoreHeader& header);

  /// Returns the number of finished pages.
  [[nodiscard]] int pages() const { return m_pages; }

  /// Adds tiles to the current page, in the order of its rows. Throws InputError.
  void add(const TileBytes& tiles);
  /// Finishes a page after `page.tiles()` tiles were added. Waits until it is on the disk.
  void finishPage(const TiffPage& page);
  /// Renames the file to its final name, after all pages are finished.
  void commit();

 private:
  [[nodiscard]] std::string pageName();
  void goOn(const RandomAccessFile& part);
  void append(const void* bytes, std::size_t count);
  void writeAt(std::uint64_t at, const void* bytes, std::size_t count) const;
  void sync() const;
  [[noreturn]] void fail(int error) const;

  std::filesystem::path m_file;
  std::filesystem::path m_part;
  std::string m_description;
  Descriptor m_descriptor;
  std::uint64_t m_end = 0;
  std::uint64_t m_linkAt = firstLinkAt;
  int m_pages = 0;
  std::vector<std::uint64_t> m_offsets;
  std::vector<std::uint32_t> m_counts;
  ContentHash m_hash;           ///< of the page
  std::uint64_t m_blackAt = 0;  ///< file position of the page's only black tile; 0: none
};

}  // namespace hogelscope
