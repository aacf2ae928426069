// SPDX-License-Identifier: BSD-3-Clause
// The image of a camera state: 8-bit RGB and the mask of the pixels seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/light_field/light_field_source.h"

namespace hogelscope {

/// An image whose row 0 is the top. A pixel that is not seen is black, and 0 in the mask, else 255.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;   ///< 3·width·height
  std::vector<std::uint8_t> seen;  ///< width·height
  static constexpr std::size_t bytesPerPixel = 4;

  Image() = default;
  Image(int w, int h)
      : width(w), height(h), rgb(3 * std::size_t(w) * std::size_t(h)), seen(rgb.size() / 3) {}
  [[nodiscard]] std::size_t pixelCount() const { return seen.size(); }
  bool operator==(const Image&) const = default;
};

/// An image in code values (0 to 255) before rounding, with the mask of an Image.
struct FloatImage {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
  std::vector<std::uint8_t> seen;

  FloatImage() = default;
  FloatImage(int w, int h)
      : width(w), height(h), rgb(3 * std::size_t(w) * std::size_t(h)), seen(rgb.size() / 3) {}
};

/// Returns the image of hogel (i, j), one pixel for each direction: column u, row v, all seen.
Image hogelErrorImage(const LightFieldSource& lightField, int i, int j);

/// Rounds a code value half up to 8 bits, limited to 0 … 255.
inline std::uint8_t quantised(double codeValue) {
  if (!(codeValue > 0)) return 0;
  if (codeValue >= 255) return 255;
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): of positive numbers, half up as said
  return static_cast<std::uint8_t>(codeValue + 0.5);
}

}  // namespace hogelscope
