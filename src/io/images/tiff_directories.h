// SPDX-License-Identifier: BSD-3-Clause
// Directories of TIFF, also those of EXIF in other formats and of JPEG's list of further pictures
// (TIFF 6.0; BigTIFF; CIPA DC-007).
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hogelscope {

/// Reads as many bytes as exist from a position on; returns their number.
using ReadBytes = std::function<std::size_t(std::uint64_t at, std::span<std::byte> bytes)>;

/// A directory: the first number of each of its tags that has whole numbers.
struct TiffDirectory {
  std::map<unsigned, std::uint64_t> numbers;
  std::string description;  ///< ImageDescription, at most 64 kB of it
  std::uint64_t next = 0;   ///< position of the next directory; 0: none

  [[nodiscard]] std::uint64_t number(unsigned tag, std::uint64_t otherwise) const;
};

/// Returns the directories of a TIFF in their order, at most `most` of them, up to the first that
/// is damaged or has been there before; none for any other content. The order of their bytes is the
/// content's own.
std::vector<TiffDirectory> tiffDirectories(const ReadBytes& read, std::size_t most);

/// Returns the orientation in a block of EXIF, which may begin with "Exif"; 1 if it has none.
int exifOrientation(std::span<const std::byte> exif);

/// The pages of a TIFF that are views: all of one size and kind, the most that there are, without
/// thumbnails, levels of pyramids and masks.
struct TiffPages {
  /// The directories that are read, in the order of the views. Where `planes` is 3, three
  /// successive ones are the red, green and blue of a view.
  std::vector<std::size_t> views;
  std::size_t planes = 1;
  int orientation = 1;  ///< EXIF's, of these pages
  std::size_t all = 0;  ///< directories in the file
  std::string note;     ///< on images that have no directory, and planes; "" for nothing
};

/// Returns the pages of a file; without views if it is no TIFF or has one directory. Throws
/// InputError if it cannot be read.
TiffPages tiffPagesOf(const std::filesystem::path& file);

}  // namespace hogelscope
