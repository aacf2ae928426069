// SPDX-License-Identifier: BSD-3-Clause
// Picture files, through OpenImageIO: reading any, writing ours.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/image.h"
#include "core/light_field.h"
#include "core/progress.h"

namespace hogelscope {

/// The first value of pixels that somebody else holds.
using StoredRows = std::variant<const std::uint8_t*, const std::uint16_t*, const float*>;

/// An opened picture file; every error names it. Grey becomes RGB, alpha is light over black.
class ImageFile {
 public:
  explicit ImageFile(const std::filesystem::path& file);
  ~ImageFile();
  ImageFile(ImageFile&&) noexcept;
  ImageFile& operator=(ImageFile&&) = delete;

  [[nodiscard]] std::size_t width() const;
  [[nodiscard]] std::size_t height() const;
  [[nodiscard]] int channels() const;
  [[nodiscard]] StoredType type() const;
  [[nodiscard]] std::string format() const;  ///< such as "png"

  /// Hears rows [first, first + rows), three values a pixel; they are gone afterwards.
  using Band = std::function<void(std::size_t first, std::size_t rows, const StoredRows&)>;
  /// Reads all pixels from the top, some rows at a time. Throws InputError: damaged, not a number.
  void read(StoredType type, const Band& band, const Progress& progress);

  [[nodiscard]] const std::filesystem::path& file() const { return m_file; }

 private:
  template <class T>
  void readAs(const Band& band, const Progress& progress);
  template <class T>
  std::vector<T> readRows(std::size_t first, std::size_t rows);

  struct Input;
  std::filesystem::path m_file;
  std::unique_ptr<Input> m_input;
};

/// Bytes.
std::size_t machineMemory();
/// Throws InputError where `bytes` are more than this machine's memory.
void checkFits(std::size_t bytes, const std::filesystem::path& file);

/// 8-bit RGB. Format by extension.
void writeImage(const std::filesystem::path& file, int width, int height,
                std::span<const std::uint8_t> rgb);
/// The same as a PNG file's bytes.
std::string encodedPng(int width, int height, std::span<const std::uint8_t> rgb);
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

  struct Output;

 private:
  std::unique_ptr<Output> m_output;
};

}  // namespace hogelscope
