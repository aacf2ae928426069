// SPDX-License-Identifier: BSD-3-Clause
// Reads an image of raw planar YUV as rows of RGB (docs/formulas.md, Raw YUV).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/light_field/texel.h"
#include "core/light_field/yuv_params.h"
#include "io/images/raw_plane.h"

namespace hogelscope {

class YuvRows {
 public:
  /// Whether the file is named like raw YUV, which has no header.
  static bool isYuv(const std::filesystem::path& file);

  /// Opens a file. Throws InputError if no size is given or the file's length does not match.
  YuvRows(const std::filesystem::path& file, const YuvParams& params);

  [[nodiscard]] std::size_t width() const { return m_planes[0].width; }
  [[nodiscard]] std::size_t height() const { return m_planes[0].height; }
  [[nodiscard]] static int channels() { return 3; }
  [[nodiscard]] int bits() const { return m_params.bits; }
  [[nodiscard]] StoredType type() const {
    return bits() > 8 ? StoredType::uint16 : StoredType::uint8;
  }

  /// Returns the next row from the top as 3·width values of type(): RGB rounded to bits(), scaled
  /// to the type's full range. Valid until the next call. Throws InputError that names a sample of
  /// more bits.
  std::span<const std::uint8_t> next8() { return next(m_rgb8); }
  std::span<const std::uint16_t> next16() { return next(m_rgb16); }

 private:
  template <class T>
  std::span<const T> next(std::vector<T>& rgb);

  RandomAccessFile m_file;
  YuvParams m_params;
  std::array<RawPlane, 3> m_planes;
  std::size_t m_row = 0;  ///< the next one
  std::vector<std::uint8_t> m_rgb8;
  std::vector<std::uint16_t> m_rgb16;
};

}  // namespace hogelscope
