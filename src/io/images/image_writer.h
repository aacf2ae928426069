// SPDX-License-Identifier: BSD-3-Clause
// Writes image files, completely or not at all. All functions throw InputError that names the file
// and the reason, or Cancelled.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "io/images/image_file.h"

namespace hogelscope {

/// Writes 8-bit RGB, or to PNG and TIFF RGBA that is not premultiplied, as the number of values
/// says. The extension chooses the format.
void writeImage(const std::filesystem::path& file, int width, int height,
                std::span<const std::uint8_t> values, const Progress& progress = {});
/// Returns 8-bit RGB as the bytes of a PNG file.
std::string encodedPng(int width, int height, std::span<const std::uint8_t> rgb,
                       const Progress& progress = {});
/// Writes named planes of width·height floats each as EXR.
void writePlanes(const std::filesystem::path& file, int width, int height,
                 const std::vector<std::pair<std::string, std::vector<float>>>& planes);
/// Writes code values: to EXR as floats divided by 255, to TIFF rounded to 16 bits.
void writeImage(const std::filesystem::path& file, int width, int height,
                std::span<const float> rgb);
/// Writes 8-bit grey.
void writeMask(const std::filesystem::path& file, int width, int height,
               std::span<const std::uint8_t> grey);

/// Writes RGB of any size, row by row, in bounded memory.
class ImageRowWriter {
 public:
  /// Creates a file. Throws InputError also if its format cannot hold values of the type.
  ImageRowWriter(const std::filesystem::path& file, std::size_t width, std::size_t height,
                 StoredType type = StoredType::uint8);
  ~ImageRowWriter();
  ImageRowWriter(const ImageRowWriter&) = delete;
  ImageRowWriter& operator=(const ImageRowWriter&) = delete;
  /// Writes the next row of 3·width values of the type.
  void write(const StoredRows& row);
  void finish();
  /// Discards the file instead of finish(). Returns the size that it would have had.
  std::uintmax_t discard();

  struct Output;

 private:
  std::unique_ptr<Output> m_output;
};

}  // namespace hogelscope
