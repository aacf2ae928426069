// SPDX-License-Identifier: BSD-3-Clause
// MSE, PSNR and SSIM of two pictures.
#include "core/metrics.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hogelscope {

namespace {

constexpr int windowSize = 11;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A picture of real numbers, row by row.
struct Plane {
  std::size_t width;
  std::size_t height;
  std::vector<double> values;
};

std::array<double, windowSize> gaussian(double sigma) {
  std::array<double, windowSize> w{};
  double sum = 0;
  for (int k = 0; k < windowSize; ++k) {
    const int x = k - windowSize / 2;
    w[std::size_t(k)] = std::exp(-x * x / (2 * sigma * sigma));
    sum += w[std::size_t(k)];
  }
  for (double& weight : w) weight /= sum;
  return w;
}

/// Gaussian mean of f(pixel) round every place where the window lies inside.
template <class F>
Plane filtered(const Image& image, F f) {
  static const auto w = gaussian(1.5);
  const auto width = std::size_t(image.width);
  const auto height = std::size_t(image.height);
  Plane rows{width - windowSize + 1, height, {}};
  rows.values.resize(rows.width * rows.height);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < rows.width; ++x)
      for (std::size_t k = 0; k < windowSize; ++k)
        rows.values[y * rows.width + x] += w[k] * f(y * width + x + k);
  Plane out{rows.width, height - windowSize + 1, {}};
  out.values.resize(out.width * out.height);
  for (std::size_t y = 0; y < out.height; ++y)
    for (std::size_t k = 0; k < windowSize; ++k)
      for (std::size_t x = 0; x < out.width; ++x)
        out.values[y * out.width + x] += w[k] * rows.values[(y + k) * rows.width + x];
  return out;
}

std::vector<double> luma(const Image& image) {
  std::vector<double> y(image.pixelCount());
  for (std::size_t p = 0; p < y.size(); ++p)
    y[p] = 0.299 * image.rgb[3 * p] + 0.587 * image.rgb[3 * p + 1] + 0.114 * image.rgb[3 * p + 2];
  return y;
}

}  // namespace

double psnr(double mse) {
  return 10 * std::log10(255.0 * 255.0 / mse);
}

double ssim(const Image& reference, const Image& test) {
  if (reference.width < windowSize || reference.height < windowSize) return nothing;
  const std::vector<double> a = luma(reference);
  const std::vector<double> b = luma(test);
  const Plane meanA = filtered(reference, [&](std::size_t p) { return a[p]; });
  const Plane meanB = filtered(test, [&](std::size_t p) { return b[p]; });
  const Plane meanAA = filtered(reference, [&](std::size_t p) { return a[p] * a[p]; });
  const Plane meanBB = filtered(test, [&](std::size_t p) { return b[p] * b[p]; });
  const Plane meanAB = filtered(reference, [&](std::size_t p) { return a[p] * b[p]; });
  constexpr double c1 = (0.01 * 255) * (0.01 * 255);
  constexpr double c2 = (0.03 * 255) * (0.03 * 255);
  double sum = 0;
  for (std::size_t p = 0; p < meanA.values.size(); ++p) {
    const double ma = meanA.values[p];
    const double mb = meanB.values[p];
    const double varianceA = meanAA.values[p] - ma * ma;
    const double varianceB = meanBB.values[p] - mb * mb;
    const double covariance = meanAB.values[p] - ma * mb;
    sum += (2 * ma * mb + c1) * (2 * covariance + c2) /
           ((ma * ma + mb * mb + c1) * (varianceA + varianceB + c2));
  }
  return sum / double(meanA.values.size());
}

Metrics compare(const Image& reference, const Image& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw std::invalid_argument("compare: pictures of different sizes");
  double all = 0;
  double inSeen = 0;
  std::size_t seenCount = 0;
  for (std::size_t p = 0; p < reference.pixelCount(); ++p) {
    double squares = 0;
    for (std::size_t c = 3 * p; c < 3 * p + 3; ++c) {
      const double difference = double(reference.rgb[c]) - double(test.rgb[c]);
      squares += difference * difference;
    }
    all += squares;
    if (reference.seen[p] == 0 || test.seen[p] == 0) continue;
    inSeen += squares;
    ++seenCount;
  }
  const auto pixels = double(reference.pixelCount());
  return {all / (3 * pixels), seenCount == 0 ? nothing : inSeen / (3 * double(seenCount)),
          ssim(reference, test), double(seenCount) / pixels};
}

}  // namespace hogelscope
