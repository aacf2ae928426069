// SPDX-License-Identifier: BSD-3-Clause
// MSE, PSNR and SSIM of two pictures.
#include "core/metrics/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

constexpr int windowSize = 11;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
using Window = std::array<double, windowSize>;

Window gaussian(double sigma) {
  Window w{};
  double sum = 0;
  for (int k = 0; k < windowSize; ++k) {
    const int x = k - windowSize / 2;
    w[std::size_t(k)] = std::exp(-x * x / (2 * sigma * sigma));
    sum += w[std::size_t(k)];
  }
  for (double& weight : w) weight /= sum;
  return w;
}

/// What SSIM needs of a place: sums of a, b, a² + b² and ab. The variances are only needed as their
/// sum, which saves a fifth of the work.
struct Moments {
  std::vector<double> a, b, squares, products;
  explicit Moments(std::size_t width) : a(width), b(width), squares(width), products(width) {}
};

/// Gaussian sums down the columns, of the rows from `a` and `b` on.
MULTIVERSIONED
void alongColumns(const Window& w, const double* __restrict a, const double* __restrict b,
                  std::size_t width, Moments& sums) {
  double* __restrict outA = sums.a.data();
  double* __restrict outB = sums.b.data();
  double* __restrict squares = sums.squares.data();
  double* __restrict products = sums.products.data();
  for (std::size_t x = 0; x < width; ++x) {
    double sumA = 0, sumB = 0, sumSquares = 0, sumProducts = 0;
    for (std::size_t k = 0; k < windowSize; ++k) {
      const double pa = a[k * width + x];
      const double pb = b[k * width + x];
      sumA += w[k] * pa;
      sumB += w[k] * pb;
      sumSquares += w[k] * (pa * pa + pb * pb);
      sumProducts += w[k] * (pa * pb);
    }
    outA[x] = sumA;
    outB[x] = sumB;
    squares[x] = sumSquares;
    products[x] = sumProducts;
  }
}

/// Gaussian sums of those sums along the row, and SSIM of each place.
MULTIVERSIONED
void alongRow(const Window& w, const Moments& sums, std::size_t count, double* __restrict out) {
  constexpr double c1 = (0.01 * 255) * (0.01 * 255);
  constexpr double c2 = (0.03 * 255) * (0.03 * 255);
  const double* __restrict a = sums.a.data();
  const double* __restrict b = sums.b.data();
  const double* __restrict squares = sums.squares.data();
  const double* __restrict products = sums.products.data();
  for (std::size_t x = 0; x < count; ++x) {
    double ma = 0, mb = 0, meanSquares = 0, meanProducts = 0;
    for (std::size_t k = 0; k < windowSize; ++k) {
      ma += w[k] * a[x + k];
      mb += w[k] * b[x + k];
      meanSquares += w[k] * squares[x + k];
      meanProducts += w[k] * products[x + k];
    }
    const double meansSquared = ma * ma + mb * mb;
    out[x] = (2 * (ma * mb) + c1) * (2 * (meanProducts - ma * mb) + c2) /
             ((meansSquared + c1) * (meanSquares - meansSquared + c2));
  }
}

MULTIVERSIONED
void luma(const std::uint8_t* rgb, std::size_t count, double* __restrict y) {
  for (std::size_t p = 0; p < count; ++p)
    y[p] = 0.299 * rgb[3 * p] + 0.587 * rgb[3 * p + 1] + 0.114 * rgb[3 * p + 2];
}

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

double ssim(const Image& reference, const Image& test, const ParallelRows& parallelRows,
            const Progress& progress) {
  static const Window w = gaussian(1.5);
  if (reference.width < windowSize || reference.height < windowSize) return nothing;
  const auto width = std::size_t(reference.width);
  const std::size_t places = width - windowSize + 1;
  const std::size_t rowCount = std::size_t(reference.height) - windowSize + 1;
  constexpr std::size_t strip = 32;          // rows whose luma stays in the second-level cache
  std::vector<double> rowSums(rowCount, 0);  // added up in one order for any threads
  const Progress heard = forThreads(progress);
  parallelRows(int((rowCount + strip - 1) / strip), [&](int begin, int end) {
    Moments moments(width);
    std::vector<double> row(places);
    std::vector<double> a((strip + windowSize - 1) * width);
    std::vector<double> b(a.size());
    for (std::size_t first = strip * std::size_t(begin);
         first < std::min(strip * std::size_t(end), rowCount); first += strip) {
      hearStop(heard);
      const std::size_t count = std::min(strip, rowCount - first);
      luma(&reference.rgb[3 * first * width], (count + windowSize - 1) * width, a.data());
      luma(&test.rgb[3 * first * width], (count + windowSize - 1) * width, b.data());
      for (std::size_t y = 0; y < count; ++y) {
        alongColumns(w, &a[y * width], &b[y * width], width, moments);
        alongRow(w, moments, places, row.data());
        rowSums[first + y] = std::accumulate(row.begin(), row.end(), 0.0);
      }
    }
  });
  return std::accumulate(rowSums.begin(), rowSums.end(), 0.0) / (double(places) * double(rowCount));
}

Metrics compare(const Image& reference, const Image& test, const ParallelRows& parallelRows,
                const Progress& progress) {
  if (reference.width != test.width || reference.height != test.height)
    throw std::invalid_argument("compare: pictures of different sizes");
  const Progress heard = forThreads(progress);
  Squares sums;
  for (std::size_t from = 0; from < reference.pixelCount(); from += pieceSize) {
    hearStop(heard);
    addSquares(&reference.rgb[3 * from], &test.rgb[3 * from], &reference.seen[from],
               &test.seen[from], std::min(pieceSize, reference.pixelCount() - from), sums);
  }
  const auto pixels = double(reference.pixelCount());
  // Cb = (B − Y) / 1.8556, Cr = (R − Y) / 1.5748: both span 255 as R, G and B do.
  constexpr std::array<double, 3> unit{1e4, 1.8556e4, 1.5748e4};
  for (std::size_t c = 0; c < 3; ++c) sums.yuv[c] /= pixels * unit[c] * unit[c];
  const auto inSeen = double(sums.inSeen) / (3 * double(sums.seenCount));
  return {double(sums.all) / (3 * pixels), sums.seenCount == 0 ? nothing : inSeen,
          ssim(reference, test, parallelRows, heard), double(sums.seenCount) / pixels, sums.yuv};
}

}  // namespace hogelscope
