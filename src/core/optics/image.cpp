// SPDX-License-Identifier: BSD-3-Clause
// Images: rounding, and the image of a hogel.
#include "core/optics/image.h"

#include <utility>

namespace hogelscope {

Image hogelTexels(const LightFieldSource& lightField, int i, int j) {
  const LightFieldSize size = lightField.size();
  Image image(size.du, size.dv);
  auto to = image.rgb.begin();
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const Rgb light = lightField.texel({i, j, u, v});
      for (const double value : {light.r, light.g, light.b}) *to++ = quantised(value);
    }
  }
  image.seen.assign(image.pixelCount(), 255);
  return image;
}

namespace {

std::uint16_t deepValue(double codeValue, int bits) {
  const int most = largestValue(bits);
  if (!(codeValue > 0)) return 0;
  if (codeValue >= 255) return static_cast<std::uint16_t>(most);
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): of positive numbers, half up as said
  return static_cast<std::uint16_t>(codeValue * most / 255 + 0.5);
}

}  // namespace

void setValues(Image& image, std::size_t at, std::span<const float> codeValues) {
  for (std::size_t k = 0; k < codeValues.size(); ++k) {
    const auto value = double(codeValues[k]);
    image.rgb[at + k] = quantised(value);
    if (image.bits > 8) image.deep[at + k] = deepValue(value, image.bits);
    if (!image.unrounded.empty()) image.unrounded[at + k] = codeValues[k];
  }
}

Image rounded(FloatImage image, int bits, bool keepsUnrounded) {
  Image result(image.width, image.height, bits);
  setValues(result, 0, image.rgb);
  result.seen = std::move(image.seen);
  if (keepsUnrounded) result.unrounded = std::move(image.rgb);
  return result;
}

void readCodeValues(const Image& image, std::size_t at, std::span<double> result) {
  const double unit = 255.0 / largestValue(image.bits);
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = image.bits > 8 ? unit * image.deep[at + k] : image.rgb[at + k];
}

}  // namespace hogelscope
