// SPDX-License-Identifier: BSD-3-Clause
// MS-SSIM of Wang, Simoncelli and Bovik, "Multi-scale structural similarity for image quality
// assessment", Asilomar 2003: contrast and structure at five scales, luminance at the last.
//
//   MS-SSIM = (mean of l·cs at scale 5)^w5 · Π over scales 1 to 4 of (mean of cs)^w
//
// with l and cs of SSIM, as in the authors' own program, on the unrounded luma (BT.601) of the
// 8-bit image. A mean below 0, for images with opposite structure, has no such power: it counts
// as 0, and so does the result.
#include <hogelscope/plugin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace {

using namespace hogelscope;

constexpr std::array<double, 5> weights{0.0448, 0.2856, 0.3001, 0.2363, 0.1333};
constexpr std::size_t windowSize = 11;
constexpr double sigma = 1.5;
constexpr double c1 = (0.01 * 255) * (0.01 * 255);
constexpr double c2 = (0.03 * 255) * (0.03 * 255);

struct Plane {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<double> values;

  Plane(std::size_t w, std::size_t h) : width(w), height(h), values(w * h) {}
};

Plane lumaOf(const plugin::View& view) {
  Plane luma(std::size_t(view.width), std::size_t(view.height));
  for (std::size_t p = 0; p < luma.values.size(); ++p)
    luma.values[p] =
        0.299 * view.rgb[3 * p] + 0.587 * view.rgb[3 * p + 1] + 0.114 * view.rgb[3 * p + 2];
  return luma;
}

/// Returns means of 2×2 pixels; the last column and row of an odd size are repeated.
Plane halved(const Plane& from) {
  Plane half((from.width + 1) / 2, (from.height + 1) / 2);
  for (std::size_t y = 0; y < half.height; ++y) {
    const double* upper = &from.values[2 * y * from.width];
    const double* lower = &from.values[std::min(2 * y + 1, from.height - 1) * from.width];
    for (std::size_t x = 0; x < half.width; ++x) {
      const std::size_t left = 2 * x;
      const std::size_t right = std::min(left + 1, from.width - 1);
      half.values[y * half.width + x] =
          0.25 * ((upper[left] + upper[right]) + (lower[left] + lower[right]));
    }
  }
  return half;
}

std::array<double, windowSize> gaussian() {
  std::array<double, windowSize> window{};
  double sum = 0;
  for (std::size_t k = 0; k < windowSize; ++k) {
    const double x = double(k) - double(windowSize - 1) / 2;
    window[k] = std::exp(-x * x / (2 * sigma * sigma));
    sum += window[k];
  }
  for (double& weight : window) weight /= sum;
  return window;
}

/// Returns Gaussian means over the places whose whole window lies inside: along rows, then columns.
Plane blurred(const Plane& from) {
  static const std::array<double, windowSize> window = gaussian();
  Plane along(from.width - windowSize + 1, from.height);
  for (std::size_t y = 0; y < along.height; ++y)
    for (std::size_t x = 0; x < along.width; ++x)
      for (std::size_t k = 0; k < windowSize; ++k)
        along.values[y * along.width + x] += window[k] * from.values[y * from.width + x + k];
  Plane across(along.width, along.height - windowSize + 1);
  for (std::size_t y = 0; y < across.height; ++y)
    for (std::size_t k = 0; k < windowSize; ++k)
      for (std::size_t x = 0; x < across.width; ++x)
        across.values[y * across.width + x] += window[k] * along.values[(y + k) * along.width + x];
  return across;
}

template <class Function>
Plane combined(const Plane& a, const Plane& b, Function function) {
  Plane result(a.width, a.height);
  std::transform(a.values.begin(), a.values.end(), b.values.begin(), result.values.begin(),
                 function);
  return result;
}

/// Means over the places of a scale.
struct Similarity {
  double cs = 0;   ///< contrast and structure
  double lcs = 0;  ///< luminance too: SSIM
};

/// Returns the means; only the sum of the variances is needed.
Similarity similarityOf(const Plane& a, const Plane& b) {
  const Plane meansA = blurred(a);
  const Plane meansB = blurred(b);
  const Plane squares = blurred(combined(a, b, [](double p, double q) { return p * p + q * q; }));
  const Plane products = blurred(combined(a, b, [](double p, double q) { return p * q; }));
  Similarity sum;
  for (std::size_t k = 0; k < meansA.values.size(); ++k) {
    const double ma = meansA.values[k];
    const double mb = meansB.values[k];
    const double meansSquared = ma * ma + mb * mb;
    const double cs =
        (2 * (products.values[k] - ma * mb) + c2) / (squares.values[k] - meansSquared + c2);
    sum.cs += cs;
    sum.lcs += cs * (2 * (ma * mb) + c1) / (meansSquared + c1);
  }
  const auto places = double(meansA.values.size());
  return {sum.cs / places, sum.lcs / places};
}

class MsSsim final : public plugin::Metric {
 public:
  [[nodiscard]] const char* title() const override { return "MS\u2011SSIM"; }
  [[nodiscard]] std::int32_t decimals() const override { return 4; }

  /// Returns NaN if the last scale is smaller than the window: below 161 pixels.
  [[nodiscard]] double compare(const plugin::View& reference, const plugin::View& test,
                               const plugin::Viewing& /*viewing*/) const override {
    constexpr auto reduction = std::int32_t{1} << (weights.size() - 1);
    constexpr auto least = std::int32_t(windowSize - 1) * reduction + 1;
    if (std::min(reference.width, reference.height) < least)
      return std::numeric_limits<double>::quiet_NaN();
    Plane a = lumaOf(reference);
    Plane b = lumaOf(test);
    double result = 1;
    for (std::size_t scale = 0; scale < weights.size(); ++scale) {
      const bool isLast = scale + 1 == weights.size();
      const Similarity similarity = similarityOf(a, b);
      result *= std::pow(std::max(0.0, isLast ? similarity.lcs : similarity.cs), weights[scale]);
      if (isLast) break;
      a = halved(a);
      b = halved(b);
    }
    return result;
  }
};

plugin::Metric* makeMsSsim() {
  return new MsSsim;
}

}  // namespace

HOGELSCOPE_PLUGIN("ms-ssim", "1.0", nullptr, nullptr, makeMsSsim);
