// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/stereo_image.h"

#include <algorithm>
#include <array>

#include "core/base/parallel.h"
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

double limited(double light) {
  return std::clamp(light, 0.0, 1.0);
}

/// The linear light of the 256 code values, and the code values of light: quantised() of
/// encodedFromLinear() without their power, for the same results.
class LightTables {
 public:
  LightTables() {
    for (std::size_t code = 0; code < m_light.size(); ++code) {
      m_light[code] = linearFromEncoded(double(code));
      m_least[code] = code == 0 ? 0 : leastOf(code);
    }
    m_least.back() = 2;  // above all light
    for (std::size_t k = 0, code = 0; k < m_first.size(); ++k) {
      while (double(k) / parts >= m_least[code + 1]) ++code;
      m_first[k] = std::uint8_t(code);
    }
  }

  [[nodiscard]] double lightOf(std::uint8_t code) const { return m_light[code]; }
  [[nodiscard]] std::uint8_t codeOf(double light) const {
    const double x = limited(light);
    // Without the checks of operator[], as in colourAnaglyph(): x is in 0 … 1.
    const std::uint8_t code = m_first.data()[unsigned(x * parts)];
    return std::uint8_t(code + int(x >= m_least.data()[code + 1]));
  }

 private:
  /// So many that a part has one step at most: the steepest are 255 · 12.92.
  static constexpr double parts = 8192;

  /// Returns the least light of a code value above 0, to the last bit.
  static double leastOf(std::size_t code) {
    double below = 0, above = 1;
    for (;;) {
      const double middle = (below + above) / 2;
      if (middle <= below || middle >= above) return above;
      (quantised(encodedFromLinear(middle)) < code ? below : above) = middle;
    }
  }

  std::array<double, 256> m_light{};
  std::array<double, 257> m_least{};
  std::array<std::uint8_t, std::size_t(parts) + 1> m_first{};
};

/// The light of code values, and back, of images of each kind.
const LightTables& codesOf(const Image& /*image*/) {
  static const LightTables tables;
  return tables;
}
struct Formulas {
  [[nodiscard]] static double lightOf(float code) { return linearFromEncoded(double(code)); }
  [[nodiscard]] static float codeOf(double light) {
    return static_cast<float>(encodedFromLinear(limited(light)));
  }
};
Formulas codesOf(const FloatImage& /*image*/) {
  return {};
}

/// The products of a matrix with the light of all code values, so that an eye's part of a pixel has
/// the bits of times().
class EyeTables {
 public:
  using Light = std::array<double, 4>;  ///< red, green, blue, and what fills a register

  EyeTables(const LightTables& codes, const Matrix& matrix) {
    for (std::size_t channel = 0; channel < 3; ++channel)
      for (std::size_t code = 0; code < 256; ++code)
        for (std::size_t row = 0; row < 3; ++row)
          m_products[256 * channel + code][row] =
              matrix[row][channel] * codes.lightOf(std::uint8_t(code));
  }

  [[nodiscard]] Light lightOf(const std::uint8_t* rgb) const {
    const Light* const products = m_products.data();
    const double* const red = products[rgb[0]].data();
    const double* const green = products[256 + rgb[1]].data();
    const double* const blue = products[512 + rgb[2]].data();
    Light light;
    for (std::size_t k = 0; k < light.size(); ++k) light[k] = red[k] + green[k] + blue[k];
    return light;
  }

 private:
  std::array<Light, std::size_t{3} * 256> m_products{};
};

/// Without the checks of operator[] for each value, which take a third of the time.
Image colourAnaglyph(const Image& left, const Image& right) {
  const LightTables& codes = codesOf(left);
  static const EyeTables leftEye(codes, ofLeft), rightEye(codes, ofRight);
  Image image(left.width, left.height);
  parallelRows(image.height, [&](int begin, int end) {
    const auto at = [&](int row) { return std::size_t(row) * std::size_t(image.width); };
    const std::uint8_t* ofOne = left.rgb.data() + 3 * at(begin);
    const std::uint8_t* ofOther = right.rgb.data() + 3 * at(begin);
    std::uint8_t* rgb = image.rgb.data() + 3 * at(begin);
    for (std::size_t pixel = at(begin); pixel < at(end);
         ++pixel, rgb += 3, ofOne += 3, ofOther += 3) {
      const auto one = leftEye.lightOf(ofOne), other = rightEye.lightOf(ofOther);
      for (std::size_t k = 0; k < 3; ++k) rgb[k] = codes.codeOf(one[k] + other[k]);
    }
    std::transform(left.seen.data() + at(begin), left.seen.data() + at(end),
                   right.seen.data() + at(begin), image.seen.data() + at(begin),
                   [](std::uint8_t one, std::uint8_t other) { return std::max(one, other); });
  });
  return image;
}

template <class AnyImage>
AnyImage anaglyph(const AnyImage& left, const AnyImage& right, bool isGrey) {
  if constexpr (std::is_same_v<AnyImage, Image>)
    if (!isGrey) return colourAnaglyph(left, right);
  AnyImage image(left.width, left.height);
  const auto& codes = codesOf(image);
  const auto lightAt = [&](const AnyImage& of, std::size_t pixel) {
    const auto* const rgb = &of.rgb[3 * pixel];
    const Rgb light{codes.lightOf(rgb[0]), codes.lightOf(rgb[1]), codes.lightOf(rgb[2])};
    return isGrey ? grey(light) : light;
  };
  parallelRows(image.height, [&](int begin, int end) {
    const auto at = [&](int row) { return std::size_t(row) * std::size_t(image.width); };
    for (std::size_t pixel = at(begin); pixel < at(end); ++pixel) {
      const Rgb sum = times(ofLeft, lightAt(left, pixel)) + times(ofRight, lightAt(right, pixel));
      auto* const rgb = &image.rgb[3 * pixel];
      rgb[0] = codes.codeOf(sum.r);
      rgb[1] = codes.codeOf(sum.g);
      rgb[2] = codes.codeOf(sum.b);
      image.seen[pixel] = std::max(left.seen[pixel], right.seen[pixel]);
    }
  });
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
