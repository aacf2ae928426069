// SPDX-License-Identifier: BSD-3-Clause
// Reads the rows of PGX, single-component images of JPEG 2000 and JPEG Pleno.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/light_field/texel.h"
#include "io/images/raw_plane.h"

namespace hogelscope {

class PgxRows {
 public:
  /// Whether the file begins like a PGX, or is named like one.
  static bool isPgx(const std::filesystem::path& file);

  /// Opens a component as a grey image. If its folder is named 0 and the sibling folders 1 and 2
  /// have files of the same name, these are green and blue, as JPEG Pleno's reference software
  /// writes them. Throws InputError if damaged, or if the components differ in size or bits.
  explicit PgxRows(const std::filesystem::path& file);

  [[nodiscard]] std::size_t width() const { return m_components[0].plane.width; }
  [[nodiscard]] std::size_t height() const { return m_components[0].plane.height; }
  [[nodiscard]] int channels() const { return int(m_components.size()); }
  [[nodiscard]] int bits() const { return m_components[0].plane.bits; }  ///< 1 … 16
  [[nodiscard]] StoredType type() const {
    return bits() > 8 ? StoredType::uint16 : StoredType::uint8;
  }

  /// Returns the next row from the top as 3·width values of type(), scaled to its full range. Valid
  /// until the next call. Throws InputError that names a damaged sample.
  std::span<const std::uint8_t> next8() { return next(m_rgb8); }
  std::span<const std::uint16_t> next16() { return next(m_rgb16); }

 private:
  struct Component {
    RandomAccessFile file;
    RawPlane plane;
  };
  static Component opened(const std::filesystem::path& file);
  template <class T>
  std::span<const T> next(std::vector<T>& rgb);

  std::vector<Component> m_components;  ///< one, or three
  std::size_t m_row = 0;                ///< the next one
  std::vector<std::uint8_t> m_rgb8;
  std::vector<std::uint16_t> m_rgb16;
};

}  // namespace hogelscope
