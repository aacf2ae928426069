// SPDX-License-Identifier: BSD-3-Clause
// Sums of squared differences, exact integers for images of 8 bits.
#include "core/metrics/squared_error.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

/// The number of pixels whose sums of squares and products fit 32 bits: 255² · 3 · 8192 < 2³¹.
constexpr std::size_t pieceSize = 8192;

/// Sums of squared differences over some pixels: of R, G and B, and of Y, Cb and Cr in units that
/// make BT.709's coefficients integers. The sums are integers for images of 8 bits.
struct Squares {
  double rgb = 0;
  std::array<double, 3> yuv{};
  double pixels = 0;
};

/// Returns Σ (r·red + g·green + b·blue)² from the sums of r², g², b², rg, rb, gb.
double quadratic(const std::array<std::int64_t, 3>& c, const std::array<std::int32_t, 6>& sums) {
  const std::array<std::int64_t, 6> coefficients{c[0] * c[0],     c[1] * c[1],     c[2] * c[2],
                                                 2 * c[0] * c[1], 2 * c[0] * c[2], 2 * c[1] * c[2]};
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < 6; ++k) sum += coefficients[k] * sums[k];
  return double(sum);
}

/// Adds the squares of the pixels marked 1 in `counts`, at most `pieceSize`.
MULTIVERSIONED
void addSquares(const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* counts,
                std::size_t count, Squares& sums) {
  std::int32_t rr = 0, gg = 0, bb = 0, rg = 0, rb = 0, gb = 0, pixels = 0;
  for (std::size_t p = 0; p < count; ++p) {
    const std::int32_t one = counts[p];
    const std::int32_t red = one * (a[3 * p] - b[3 * p]);
    const std::int32_t green = one * (a[3 * p + 1] - b[3 * p + 1]);
    const std::int32_t blue = one * (a[3 * p + 2] - b[3 * p + 2]);
    rr += red * red;
    gg += green * green;
    bb += blue * blue;
    rg += red * green;
    rb += red * blue;
    gb += green * blue;
    pixels += one;
  }
  sums.rgb += rr + gg + bb;
  sums.pixels += pixels;
  sums.yuv[0] += quadratic({2126, 7152, 722}, {rr, gg, bb, rg, rb, gb});
  sums.yuv[1] += quadratic({-2126, -7152, 9278}, {rr, gg, bb, rg, rb, gb});  // B − Y
  sums.yuv[2] += quadratic({7874, -7152, -722}, {rr, gg, bb, rg, rb, gb});   // R − Y
}

/// Adds the same for unrounded code values. Uses differences of differences, so that differing grey
/// values have exactly no colour error.
MULTIVERSIONED
void addSquares(const double* a, const double* b, const std::uint8_t* counts, std::size_t count,
                Squares& sums) {
  for (std::size_t p = 0; p < count; ++p) {
    const double one = counts[p];
    const double red = one * (a[3 * p] - b[3 * p]);
    const double green = one * (a[3 * p + 1] - b[3 * p + 1]);
    const double blue = one * (a[3 * p + 2] - b[3 * p + 2]);
    const double y = 2126 * red + 7152 * green + 722 * blue;
    const double cb = 2126 * (blue - red) + 7152 * (blue - green);
    const double cr = 7152 * (red - green) + 722 * (red - blue);
    sums.rgb += red * red + green * green + blue * blue;
    sums.yuv[0] += y * y;
    sums.yuv[1] += cb * cb;
    sums.yuv[2] += cr * cr;
    sums.pixels += one;
  }
}

/// Sums over all pixels and over those seen in both images.
struct BothSquares {
  Squares all;
  Squares seen;
};

template <class T>
void addPiece(const T* a, const T* b, const std::vector<std::uint8_t>& seen, BothSquares& sums) {
  static const std::vector<std::uint8_t> everything(pieceSize, 1);
  addSquares(a, b, everything.data(), seen.size(), sums.all);
  addSquares(a, b, seen.data(), seen.size(), sums.seen);
}

void addPiece(const Image& reference, const Image& test, std::size_t from, std::size_t count,
              BothSquares& sums) {
  std::vector<std::uint8_t> seen(count);
  for (std::size_t p = 0; p < count; ++p)
    seen[p] = reference.seen[from + p] != 0 && test.seen[from + p] != 0 ? 1 : 0;
  if (reference.bits == 8 && test.bits == 8)
    return addPiece(&reference.rgb[3 * from], &test.rgb[3 * from], seen, sums);
  std::vector<double> a(3 * count);
  std::vector<double> b(a.size());
  readCodeValues(reference, 3 * from, a);
  readCodeValues(test, 3 * from, b);
  addPiece(a.data(), b.data(), seen, sums);
}

/// Cb = (B − Y) / 1.8556 and Cr = (R − Y) / 1.5748 span 255, as R, G and B do.
std::array<double, 3> meanYuv(const Squares& sums) {
  constexpr std::array<double, 3> unit{1e4, 1.8556e4, 1.5748e4};
  std::array<double, 3> means{};
  for (std::size_t c = 0; c < 3; ++c) means[c] = sums.yuv[c] / (sums.pixels * unit[c] * unit[c]);
  return means;
}

}  // namespace

double psnr(double mse) {
  return 10 * std::log10(255.0 * 255.0 / mse);
}

double psnrYuv(const std::array<double, 3>& mseYuv) {
  return (6 * psnr(mseYuv[0]) + psnr(mseYuv[1]) + psnr(mseYuv[2])) / 8;
}

SquaredError squaredError(const Image& reference, const Image& test, const Progress& progress) {
  BothSquares sums;
  for (std::size_t from = 0; from < reference.pixelCount(); from += pieceSize) {
    throwIfCancelled(progress);
    addPiece(reference, test, from, std::min(pieceSize, reference.pixelCount() - from), sums);
  }
  const auto& [all, seen] = sums;
  return {all.rgb / (3 * all.pixels), seen.rgb / (3 * seen.pixels), seen.pixels / all.pixels,
          meanYuv(all), meanYuv(seen)};
}

}  // namespace hogelscope
