// SPDX-License-Identifier: BSD-3-Clause
// The difference of two images as an image.
#include "core/metrics/difference.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

namespace hogelscope {

namespace {

/// `counts` of the values 0 … 255.
int gainFor(const std::array<std::size_t, 256>& counts) {
  std::size_t above = 0;  // values larger than `largest`
  const std::size_t all = std::accumulate(counts.begin() + 1, counts.end(), std::size_t{0});
  std::size_t largest = 255;
  while (largest > 0 && 1000 * (above + counts[largest]) <= all) above += counts[largest--];
  int gain = 1;
  while (largest > 0 && 2 * gain * static_cast<int>(largest) <= 255) gain *= 2;
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
  writeDifference(reference.rgb, test.rgb, 1, image.rgb);
  std::array<std::size_t, 256> counts{};
  for (const std::uint8_t value : image.rgb) ++counts[value];
  result.gain = gainFor(counts);
  writeDifference(reference.rgb, test.rgb, result.gain, image.rgb);
  for (std::size_t k = 0; k < image.seen.size(); ++k)
    image.seen[k] = std::min(reference.seen[k], test.seen[k]);
  return result;
}

}  // namespace hogelscope
