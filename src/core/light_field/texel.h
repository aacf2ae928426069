// SPDX-License-Identifier: BSD-3-Clause
// Directional pixels (texels): their number, their index and their light.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hogelscope {

/// nx × ny hogels of du × dv directional pixels.
struct LightFieldSize {
  int nx = 0;
  int ny = 0;
  int du = 0;
  int dv = 0;
  [[nodiscard]] std::size_t width() const { return std::size_t(nx) * std::size_t(du); }
  [[nodiscard]] std::size_t height() const { return std::size_t(ny) * std::size_t(dv); }
  bool operator==(const LightFieldSize&) const = default;
};

/// The index of a directional pixel: hogel (i, j) from the panel's top left, direction (u, v); u
/// grows for light that leaves to the right, v = 0 leaves upwards.
struct TexelIndex {
  int i = 0;
  int j = 0;
  int u = 0;
  int v = 0;
  bool operator==(const TexelIndex&) const = default;
};

/// Red, green, blue in code values: 0 … 255 is the range of an 8-bit image, fractions kept.
struct Rgb {
  double r = 0;
  double g = 0;
  double b = 0;
  bool operator==(const Rgb&) const = default;
};

constexpr Rgb operator+(const Rgb& a, const Rgb& b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Rgb operator*(double s, const Rgb& c) {
  return {s * c.r, s * c.g, s * c.b};
}

enum class StoredType { uint8, uint16, real };

/// Returns the size of a texel in memory.
constexpr std::size_t memoryBytes(StoredType type) {
  return std::array<std::size_t, 3>{4, 8, 16}[std::size_t(type)];
}

/// Returns the bytes of red, green and blue in a file.
constexpr std::size_t pixelBytes(StoredType type) {
  return memoryBytes(type) / 4 * 3;
}

/// Calls work(T{}), where T is the type of the values.
template <class Work>
void withStoredType(StoredType type, Work work) {
  switch (type) {
    case StoredType::uint8:
      return work(std::uint8_t{});
    case StoredType::uint16:
      return work(std::uint16_t{});
    default:
      return work(float{});
  }
}

}  // namespace hogelscope
