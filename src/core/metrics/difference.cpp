// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace hogelscope {

namespace {

/// Returns the gain for the `counts` of the values 0 … 255.
int gainFor(const std::array<std::size_t, 256>& counts) {
  std::size_t above = 0;  // values larger than `largest`
  const std::size_t all = std::accumulate(counts.begin() + 1, counts.end(), std::size_t{0});
  std::size_t largest = 255;
  while (largest > 0 && 1000 * (above + counts[largest]) <= all) above += counts[largest--];
  int gain = 1;
  while (largest > 0 && 2 * gain * static_cast<int>(largest) <= 255) gain *= 2;
  return gain;
}

/// Writes |a − b| in unrounded code values into `rgb`, multiplied by the gain and rounded. Returns
/// the gain.
int writeDeepDifference(const Image& a, const Image& b, std::span<std::uint8_t> rgb) {
  std::vector<double> differences(rgb.size());
  std::vector<double> others(rgb.size());
  readCodeValues(a, 0, differences);
  readCodeValues(b, 0, others);
  std::ranges::transform(differences, others, differences.begin(),
                         [](double p, double q) { return std::abs(p - q); });
  std::vector<double> sorted;
  std::ranges::copy_if(differences, std::back_inserter(sorted), [](double d) { return d > 0; });
  std::ranges::sort(sorted);
  int gain = 1;
  if (!sorted.empty()) {
    const double largest = sorted[sorted.size() - 1 - sorted.size() / 1000];
    while (gain < 65536 && 2 * gain * largest <= 255) gain *= 2;
  }
  std::ranges::transform(differences, rgb.begin(),
                         [gain](double d) { return quantised(gain * d); });
  return gain;
}

}  // namespace

void writeDifference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, int gain,
                     std::span<std::uint8_t> result) {
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = static_cast<std::uint8_t>(std::min(gain * std::abs(a[k] - b[k]), 255));
}

DifferenceImage differenceImage(const Image& reference, const Image& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw std::invalid_argument("differenceImage: pictures of different sizes");
  DifferenceImage result{Image(reference.width, reference.height)};
  Image& image = result.image;
  for (std::size_t k = 0; k < image.seen.size(); ++k)
    image.seen[k] = std::min(reference.seen[k], test.seen[k]);
  if (reference.bits > 8 || test.bits > 8) {
    result.gain = writeDeepDifference(reference, test, image.rgb);
    return result;
  }
  writeDifference(reference.rgb, test.rgb, 1, image.rgb);
  std::array<std::size_t, 256> counts{};
  for (const std::uint8_t value : image.rgb) ++counts[value];
  result.gain = gainFor(counts);
  writeDifference(reference.rgb, test.rgb, result.gain, image.rgb);
  return result;
}

}  // namespace hogelscope
