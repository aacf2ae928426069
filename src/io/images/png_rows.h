// SPDX-License-Identifier: BSD-3-Clause
// Reads the rows of a PNG by libspng. Light fields of 283 GB are such files; OpenImageIO reads them
// at 0.4 times the speed and lets libpng print on stderr.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "core/light_field/light_field.h"

struct spng_ctx;

namespace hogelscope {

class PngRows {
 public:
  /// Whether the file begins like a PNG.
  static bool isPng(const std::filesystem::path& file);

  /// Opens a file. Throws InputError if it cannot be read or its header is damaged.
  explicit PngRows(const std::filesystem::path& file);

  [[nodiscard]] std::size_t width() const { return m_width; }
  [[nodiscard]] std::size_t height() const { return m_height; }
  /// Returns the stored channels, 1 to 4; a palette counts as its colours.
  [[nodiscard]] int channels() const { return m_channels; }
  [[nodiscard]] int bits() const { return m_type == StoredType::uint8 ? 8 : 16; }
  /// Returns 16 bits, or 8 for all files with fewer.
  [[nodiscard]] StoredType type() const { return m_type; }

  /// Returns the next row from the top as 3·width values of type(); grey becomes RGB, alpha is
  /// composited over black. Valid until the next call. Throws InputError that names a damaged row.
  std::span<const std::uint8_t> next8();
  std::span<const std::uint16_t> next16();

 private:
  using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
  using Context = std::unique_ptr<spng_ctx, void (*)(spng_ctx*)>;
  void readHeader();
  void begin();
  const std::byte* nextRow();
  void check(int status, const std::string& what = "is damaged") const;

  std::filesystem::path m_file;
  File m_input;
  Context m_context;
  std::size_t m_width = 0;
  std::size_t m_height = 0;
  int m_channels = 0;
  StoredType m_type = StoredType::uint8;
  bool m_hasAlpha = false;
  bool m_isInterlaced = false;
  int m_format = 0;                  ///< a format of libspng
  std::size_t m_rowBytes = 0;        ///< in that format
  std::size_t m_row = 0;             ///< the next one
  std::vector<std::byte> m_decoded;  ///< a row, or all rows of an interlaced file
  std::vector<std::uint8_t> m_rgb8;
  std::vector<std::uint16_t> m_rgb16;
};

}  // namespace hogelscope
