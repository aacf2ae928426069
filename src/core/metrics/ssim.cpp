// SPDX-License-Identifier: BSD-3-Clause
// SSIM with Gaussian sums down the columns, then along the row.
#include "core/metrics/ssim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/multiversioned.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

namespace {

constexpr int windowSize = 11;
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

/// The sums needed for SSIM at a place: a, b, a² + b² and ab. Only the sum of the variances is
/// needed, which saves a fifth of the work.
struct Moments {
  std::vector<double> a, b, squares, products;
  explicit Moments(std::size_t width) : a(width), b(width), squares(width), products(width) {}
};

/// Computes Gaussian sums down the columns, over the rows starting at `a` and `b`.
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

/// Computes Gaussian sums of those sums along the row, and the SSIM of each place.
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

template <class T>
MULTIVERSIONED void luma(const T* rgb, std::size_t count, double* __restrict y) {
  for (std::size_t p = 0; p < count; ++p)
    y[p] = 0.299 * rgb[3 * p] + 0.587 * rgb[3 * p + 1] + 0.114 * rgb[3 * p + 2];
}

void luma(const Image& image, std::size_t from, std::size_t count, double* y) {
  if (image.bits == 8) return luma(&image.rgb[3 * from], count, y);
  std::vector<double> values(3 * count);
  readCodeValues(image, 3 * from, values);
  luma(values.data(), count, y);
}

/// Sets 1 for each place of a row whose window has only pixels seen in both images, from the counts
/// of the window's last row.
void wholeWindows(const std::uint8_t* seenAbove, std::size_t width,
                  std::vector<std::uint8_t>& whole) {
  int run = 0;  // columns up to here that are seen over the window's height
  for (std::size_t x = 0; x < width; ++x) {
    run = seenAbove[x] < windowSize ? 0 : run + 1;
    if (x + 1 >= windowSize) whole[x + 1 - windowSize] = run >= windowSize ? 1 : 0;
  }
}

/// Sums of SSIM over the places of some rows: over all windows and over those seen completely.
struct RowSums {
  double all = 0;
  double inSeen = 0;
  std::size_t seenCount = 0;
};

RowSums sumsOf(const std::vector<double>& row, const std::vector<std::uint8_t>& whole) {
  RowSums sums;
  for (std::size_t x = 0; x < row.size(); ++x) {
    sums.all += row[x];
    if (whole[x] == 0) continue;
    sums.inSeen += row[x];
    ++sums.seenCount;
  }
  return sums;
}

constexpr std::size_t strip = 32;  // rows whose luma fits the second-level cache

/// The pixel rows needed for some rows of windows.
struct Strip {
  std::size_t width;
  std::vector<double> a, b;
  /// The number of pixels upwards from here, within the strip, seen in both images.
  std::vector<std::uint8_t> seenAbove;
  explicit Strip(std::size_t imageWidth)
      : width(imageWidth), a((strip + windowSize - 1) * width), b(a), seenAbove(a.size()) {}

  void read(const Image& reference, const Image& test, std::size_t from, std::size_t count) {
    luma(reference, from, count, a.data());
    luma(test, from, count, b.data());
    for (std::size_t p = 0; p < count; ++p) {
      const bool isSeen = reference.seen[from + p] != 0 && test.seen[from + p] != 0;
      const int above = p < width ? 0 : seenAbove[p - width];
      seenAbove[p] = static_cast<std::uint8_t>(isSeen ? above + 1 : 0);
    }
  }
};

/// Returns the means, added in a fixed order for any number of threads.
Ssim meanOf(const std::vector<RowSums>& rows, std::size_t places) {
  RowSums sums;
  for (const RowSums& row : rows) {
    sums.all += row.all;
    sums.inSeen += row.inSeen;
    sums.seenCount += row.seenCount;
  }
  return {sums.all / (double(places) * double(rows.size())), sums.inSeen / double(sums.seenCount)};
}

}  // namespace

Ssim ssim(const Image& reference, const Image& test, const ParallelRows& parallelRows,
          const Progress& progress) {
  static const Window w = gaussian(1.5);
  if (reference.width < windowSize || reference.height < windowSize)
    return {unknownFigure, unknownFigure};
  const auto width = std::size_t(reference.width);
  const std::size_t places = width - windowSize + 1;
  const std::size_t rowCount = std::size_t(reference.height) - windowSize + 1;
  std::vector<RowSums> rowSums(rowCount);
  const Progress heard = forThreads(progress);
  parallelRows(int((rowCount + strip - 1) / strip), [&](int begin, int end) {
    Moments moments(width);
    std::vector<double> row(places);
    std::vector<std::uint8_t> whole(places);
    Strip pixels(width);
    for (std::size_t first = strip * std::size_t(begin);
         first < std::min(strip * std::size_t(end), rowCount); first += strip) {
      throwIfCancelled(heard);
      const std::size_t count = std::min(strip, rowCount - first);
      pixels.read(reference, test, first * width, (count + windowSize - 1) * width);
      for (std::size_t y = 0; y < count; ++y) {
        alongColumns(w, &pixels.a[y * width], &pixels.b[y * width], width, moments);
        alongRow(w, moments, places, row.data());
        wholeWindows(&pixels.seenAbove[(y + windowSize - 1) * width], width, whole);
        rowSums[first + y] = sumsOf(row, whole);
      }
    }
  });
  return meanOf(rowSums, places);
}

}  // namespace hogelscope
