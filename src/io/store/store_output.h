// SPDX-License-Identifier: BSD-3-Clause
// A store on its way to the disk, as FILE.part. A page is in the file's chain only when all of it
// is on the disk, so that whatever ends the program, the next run goes on after the last one.
#pragma once

#include <filesystem>
#include <span>

#include "io/images/big_tiff.h"
#include "io/store/store_header.h"

namespace hogelscope {

/// Compressed tiles, one after the other.
struct TileBytes {
  std::vector<std::byte> bytes;
  std::vector<std::uint32_t> counts;  ///< of each; 0 = it is black
  std::vector<std::byte> black;       ///< a black one, if there is any
};

class StoreOutput {
 public:
  /// Goes on with FILE.part where it is of the same header, else begins it anew. Throws InputError:
  /// it is another file, another run writes it, it cannot be written.
  StoreOutput(const std::filesystem::path& file, const StoreHeader& header);

  /// Pages that are finished.
  [[nodiscard]] int pages() const { return m_pages; }
  /// Bytes so far.
  [[nodiscard]] std::uint64_t size() const { return m_end; }

  /// Adds tiles to the page in the making, in the order of its rows. Throws InputError.
  void add(const TileBytes& tiles);
  /// The page is complete: `page.tiles()` were added. Waits until the disk has it.
  void finishPage(const TiffPage& page);
  /// All pages are there: the file takes its name.
  void commit();

 private:
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
  std::uint64_t m_blackAt = 0;  ///< where the page's black tile is, of which one is enough; 0: none
};

}  // namespace hogelscope
