// SPDX-License-Identifier: BSD-3-Clause
// The difference of two pictures as a picture.
#include "core/difference.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace hogelscope {

DifferencePicture differencePicture(const Image& reference, const Image& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw std::invalid_argument("differencePicture: pictures of different sizes");
  DifferencePicture result{Image(reference.width, reference.height)};
  Image& image = result.image;
  int largest = 0;
  for (std::size_t k = 0; k < image.rgb.size(); ++k) {
    const int difference = std::abs(reference.rgb[k] - test.rgb[k]);
    image.rgb[k] = static_cast<std::uint8_t>(difference);
    largest = std::max(largest, difference);
  }
  while (largest > 0 && 2 * result.gain * largest <= 255) result.gain *= 2;
  for (std::uint8_t& value : image.rgb) value = static_cast<std::uint8_t>(value * result.gain);
  for (std::size_t k = 0; k < image.seen.size(); ++k)
    image.seen[k] = std::min(reference.seen[k], test.seen[k]);
  return result;
}

}  // namespace hogelscope
