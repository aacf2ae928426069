// SPDX-License-Identifier: BSD-3-Clause
// The image of a camera state: RGB and the mask of the pixels seen.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "core/light_field/light_field_source.h"

namespace hogelscope {

/// An image whose row 0 is the top. A pixel that is not seen is black, and 0 in the mask, else 255.
/// A pixel of a view through a pupil is seen if all points of the aperture see the display; it has
/// light if some do.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;    ///< 3·width·height
  std::vector<std::uint8_t> seen;   ///< width·height
  int bits = 8;                     ///< bits of the light field's values, 8 … 16
  std::vector<std::uint16_t> deep;  ///< rgb with this many bits; empty for 8
  std::vector<float> unrounded;     ///< rgb before rounding; empty unless it was asked for
  static constexpr std::size_t bytesPerPixel = 4;
  static constexpr std::size_t deepBytesPerPixel = 10;
  static constexpr std::size_t unroundedBytesPerPixel = 12;  ///< in addition, for unrounded values

  Image() = default;
  Image(int w, int h, int bitsOfValues = 8, bool keepsUnrounded = false)
      : width(w),
        height(h),
        rgb(3 * std::size_t(w) * std::size_t(h)),
        seen(rgb.size() / 3),
        bits(bitsOfValues),
        deep(bits > 8 ? rgb.size() : 0),
        unrounded(keepsUnrounded ? rgb.size() : 0) {}
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
Image hogelTexels(const LightFieldSource& lightField, int i, int j);

/// Returns the largest value of so many bits, which code value 255 stands for.
constexpr int largestValue(int bits) {
  return (1 << bits) - 1;
}

/// Rounds code values half up to image.bits bits, as the values of a row from value `at` on; rounds
/// them to 8 bits too, and keeps them where the image has room for unrounded values.
void setValues(Image& image, std::size_t at, std::span<const float> codeValues);

/// Returns the image rounded to so many bits, with the unrounded values if asked for.
Image rounded(FloatImage image, int bits = 8, bool keepsUnrounded = false);

/// Writes values [at, at + result.size()) of the image as code values.
void readCodeValues(const Image& image, std::size_t at, std::span<double> result);

/// Rounds a code value half up to 8 bits, limited to 0 … 255.
inline std::uint8_t quantised(double codeValue) {
  if (!(codeValue > 0)) return 0;
  if (codeValue >= 255) return 255;
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): of positive numbers, half up as said
  return static_cast<std::uint8_t>(codeValue + 0.5);
}

/// Returns a code value as a light field's texels store it: the inverse of codeValue(), rounded to
/// the nearest value of an integer type.
template <class T>
T storedValue(double codeValue) {
  if constexpr (std::is_same_v<T, float>)
    return static_cast<float>(codeValue / 255);
  else if constexpr (sizeof(T) == 1)
    return quantised(codeValue);
  else
    return static_cast<T>(std::lround(257 * std::clamp(codeValue, 0.0, 255.0)));
}

}  // namespace hogelscope
