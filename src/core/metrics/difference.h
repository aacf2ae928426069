// SPDX-License-Identifier: BSD-3-Clause
// The difference of two images as an image.
#pragma once

#include <cstdint>
#include <span>

#include "core/optics/image.h"

namespace hogelscope {

/// Writes gain · |a − b|, limited to 255, for each value. All three have the same length.
void writeDifference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, int gain,
                     std::span<std::uint8_t> result);

struct DifferenceImage {
  Image image;  ///< gain · |reference − test|, each channel; seen where both are
  /// The largest power of two that clips at most a thousandth of the differing values, so that one
  /// outlier does not hide the rest; 1 if none differ, 65536 at most.
  int gain = 1;
};

/// Computes a difference image. Throws std::invalid_argument if the sizes differ.
DifferenceImage differenceImage(const Image& reference, const Image& test);

}  // namespace hogelscope
