// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/stereo_image.h"

#include <algorithm>
#include <array>

#include "core/optics/psf.h"

namespace hogelscope {

namespace {

constexpr std::array<std::string_view, 4> modeNames{"side-by-side", "anaglyph", "anaglyph-grey",
                                                    "cross-eyed"};

using Matrix = std::array<std::array<double, 3>, 3>;  ///< rows
constexpr Matrix ofLeft{{{0.4561, 0.500484, 0.176381},
                         {-0.0400822, -0.0378246, -0.0157589},
                         {-0.0152161, -0.0205971, -0.00546856}}};
constexpr Matrix ofRight{{{-0.0434706, -0.0879388, -0.00155529},
                          {0.378476, 0.73364, -0.0184503},
                          {-0.0721527, -0.112961, 1.2264}}};

Rgb times(const Matrix& m, const Rgb& c) {
  const auto row = [&](std::size_t k) { return m[k][0] * c.r + m[k][1] * c.g + m[k][2] * c.b; };
  return {row(0), row(1), row(2)};
}

/// Returns the grey of the same luminance, in linear light.
Rgb grey(const Rgb& c) {
  const double y = luminance(c);
  return {y, y, y};
}

void setValue(std::uint8_t& value, double code) {
  value = quantised(code);
}
void setValue(float& value, double code) {
  value = static_cast<float>(code);
}

template <class AnyImage>
AnyImage anaglyph(const AnyImage& left, const AnyImage& right, bool isGrey) {
  AnyImage image(left.width, left.height);
  const auto lightAt = [&](const AnyImage& of, std::size_t pixel) {
    const auto* const rgb = &of.rgb[3 * pixel];
    const Rgb light = decoded(LightModel::linear, {double(rgb[0]), double(rgb[1]), double(rgb[2])});
    return isGrey ? grey(light) : light;
  };
  const auto limited = [](double light) { return encodedFromLinear(std::clamp(light, 0.0, 1.0)); };
  for (std::size_t pixel = 0; pixel < image.seen.size(); ++pixel) {
    const Rgb sum = times(ofLeft, lightAt(left, pixel)) + times(ofRight, lightAt(right, pixel));
    setValue(image.rgb[3 * pixel], limited(sum.r));
    setValue(image.rgb[3 * pixel + 1], limited(sum.g));
    setValue(image.rgb[3 * pixel + 2], limited(sum.b));
    image.seen[pixel] = std::max(left.seen[pixel], right.seen[pixel]);
  }
  return image;
}

/// Writes `first` on the left of `second`.
template <class AnyImage>
AnyImage joined(const AnyImage& first, const AnyImage& second) {
  AnyImage image(first.width + second.width, first.height);
  const auto copy = [&](const auto& from, auto to, int perPixel) {
    const auto row = static_cast<std::ptrdiff_t>(perPixel) * first.width;
    for (int y = 0; y < first.height; ++y)
      std::copy_n(from.begin() + y * row, row, to + 2 * y * row);
  };
  copy(first.rgb, image.rgb.begin(), 3);
  copy(second.rgb, image.rgb.begin() + 3 * std::ptrdiff_t{first.width}, 3);
  copy(first.seen, image.seen.begin(), 1);
  copy(second.seen, image.seen.begin() + first.width, 1);
  return image;
}

template <class AnyImage>
AnyImage stereo(const AnyImage& left, const AnyImage& right, StereoMode mode) {
  switch (mode) {
    case StereoMode::sideBySide:
      return joined(left, right);
    case StereoMode::crossEyed:
      return joined(right, left);
    default:
      return anaglyph(left, right, mode == StereoMode::anaglyphGrey);
  }
}

}  // namespace

std::span<const std::string_view> stereoModeNames() {
  return modeNames;
}

Image stereoImage(const Image& left, const Image& right, StereoMode mode) {
  return stereo(left, right, mode);
}

FloatImage stereoImage(const FloatImage& left, const FloatImage& right, StereoMode mode) {
  return stereo(left, right, mode);
}

}  // namespace hogelscope
