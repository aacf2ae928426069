// SPDX-License-Identifier: BSD-3-Clause
// Our picture files: whole or not there. Throws InputError that names the file and what is wrong,
// or Cancelled where a `progress` says stop.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.h"

namespace hogelscope {

/// 8-bit RGB. Format by extension.
void writeImage(const std::filesystem::path& file, int width, int height,
                std::span<const std::uint8_t> rgb, const Progress& progress = {});
/// The same as a PNG file's bytes.
std::string encodedPng(int width, int height, std::span<const std::uint8_t> rgb,
                       const Progress& progress = {});
/// Named planes of width·height floats each; EXR.
void writePlanes(const std::filesystem::path& file, int width, int height,
                 const std::vector<std::pair<std::string, std::vector<float>>>& planes);
/// Code values: EXR keeps them as floats /255, TIFF rounds them to 16 bits.
void writeImage(const std::filesystem::path& file, int width, int height,
                std::span<const float> rgb);
/// 8-bit grey.
void writeMask(const std::filesystem::path& file, int width, int height,
               std::span<const std::uint8_t> grey);

/// 8-bit RGB of any size, row by row, in bounded memory.
class ImageRowWriter {
 public:
  ImageRowWriter(const std::filesystem::path& file, std::size_t width, std::size_t height);
  ~ImageRowWriter();
  ImageRowWriter(const ImageRowWriter&) = delete;
  ImageRowWriter& operator=(const ImageRowWriter&) = delete;
  /// 3·width values.
  void write(std::span<const std::uint8_t> row);
  void finish();
  /// Instead: leaves no file, and says how many bytes it would have had.
  std::uintmax_t discard();

  struct Output;

 private:
  std::unique_ptr<Output> m_output;
};

}  // namespace hogelscope
