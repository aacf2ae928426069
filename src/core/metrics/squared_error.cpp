// SPDX-License-Identifier: BSD-3-Clause
// Sums of squared differences, exact in whole numbers.
#include "core/metrics/squared_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

/// Pixels whose sums of squares and products stay within 32 bits: 255² · 3 · 8192 < 2³¹.
constexpr std::size_t pieceSize = 8192;

/// Exact sums of squared differences of R, G and B, over all pixels and over those seen in both,
/// and of Y, Cb and Cr in units that make BT.709's coefficients whole numbers.
struct Squares {
  std::int64_t all = 0;
  std::int64_t inSeen = 0;
  std::int64_t seenCount = 0;
  std::array<double, 3> yuv{};  // whole numbers too, but they outgrow 64 bits
};

/// Σ (r·red + g·green + b·blue)² from the sums of r², g², b², rg, rb, gb.
double quadratic(const std::array<std::int64_t, 3>& c, const std::array<std::int32_t, 6>& sums) {
  const std::array<std::int64_t, 6> coefficients{c[0] * c[0],     c[1] * c[1],     c[2] * c[2],
                                                 2 * c[0] * c[1], 2 * c[0] * c[2], 2 * c[1] * c[2]};
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < 6; ++k) sum += coefficients[k] * sums[k];
  return double(sum);
}

/// Of at most `pieceSize` pixels.
MULTIVERSIONED
void addSquares(const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* seenA,
                const std::uint8_t* seenB, std::size_t count, Squares& sums) {
  std::int32_t rr = 0, gg = 0, bb = 0, rg = 0, rb = 0, gb = 0, inSeen = 0, seenCount = 0;
  for (std::size_t p = 0; p < count; ++p) {
    const std::int32_t red = a[3 * p] - b[3 * p];
    const std::int32_t green = a[3 * p + 1] - b[3 * p + 1];
    const std::int32_t blue = a[3 * p + 2] - b[3 * p + 2];
    const std::int32_t isSeen = std::int32_t(seenA[p] != 0) & std::int32_t(seenB[p] != 0);
    rr += red * red;
    gg += green * green;
    bb += blue * blue;
    rg += red * green;
    rb += red * blue;
    gb += green * blue;
    inSeen += isSeen * (red * red + green * green + blue * blue);
    seenCount += isSeen;
  }
  sums.all += rr + gg + bb;
  sums.inSeen += inSeen;
  sums.seenCount += seenCount;
  sums.yuv[0] += quadratic({2126, 7152, 722}, {rr, gg, bb, rg, rb, gb});
  sums.yuv[1] += quadratic({-2126, -7152, 9278}, {rr, gg, bb, rg, rb, gb});  // B − Y
  sums.yuv[2] += quadratic({7874, -7152, -722}, {rr, gg, bb, rg, rb, gb});   // R − Y
}

}  // namespace

double psnr(double mse) {
  return 10 * std::log10(255.0 * 255.0 / mse);
}

double psnrYuv(const std::array<double, 3>& mseYuv) {
  return (6 * psnr(mseYuv[0]) + psnr(mseYuv[1]) + psnr(mseYuv[2])) / 8;
}

SquaredError squaredError(const Image& reference, const Image& test, const Progress& progress) {
  Squares sums;
  for (std::size_t from = 0; from < reference.pixelCount(); from += pieceSize) {
    hearStop(progress);
    addSquares(&reference.rgb[3 * from], &test.rgb[3 * from], &reference.seen[from],
               &test.seen[from], std::min(pieceSize, reference.pixelCount() - from), sums);
  }
  const auto pixels = double(reference.pixelCount());
  // Cb = (B − Y) / 1.8556, Cr = (R − Y) / 1.5748: both span 255 as R, G and B do.
  constexpr std::array<double, 3> unit{1e4, 1.8556e4, 1.5748e4};
  for (std::size_t c = 0; c < 3; ++c) sums.yuv[c] /= pixels * unit[c] * unit[c];
  return {double(sums.all) / (3 * pixels),
          sums.seenCount == 0 ? std::numeric_limits<double>::quiet_NaN()
                              : double(sums.inSeen) / (3 * double(sums.seenCount)),
          double(sums.seenCount) / pixels, sums.yuv};
}

}  // namespace hogelscope
