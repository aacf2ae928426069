// SPDX-License-Identifier: BSD-3-Clause
// Uncompressed samples in a file.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "io/files/random_access_file.h"

namespace hogelscope {

/// Rows of samples of 1 to 16 bits, in one or two bytes each.
struct RawPlane {
  std::uint64_t at = 0;  ///< file position of the first sample
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  int bits = 8;
  bool isSigned = false;  ///< two's complement: −2^(bits−1) is black
  bool isBigEndian = false;

  [[nodiscard]] std::uint64_t rowBytes() const { return width * (bits > 8 ? 2U : 1U); }
  [[nodiscard]] std::uint64_t end() const { return at + rowBytes() * height; }
};

/// Returns row y as values of 0 … 2^bits − 1. Throws InputError that names the pixel of a larger
/// sample, or the file if it is too short.
std::vector<std::uint16_t> readRow(const RandomAccessFile& file, const RawPlane& plane,
                                   std::uint64_t y);

/// Scales a value of `bits` bits to the full range of T: the largest becomes T's largest, others
/// are rounded.
template <class T>
T spread(std::uint32_t value, int bits) {
  const std::uint64_t most = (std::uint64_t{1} << unsigned(bits)) - 1;
  return T((std::uint64_t{2} * value * std::uint64_t{std::numeric_limits<T>::max()} + most) /
           (2 * most));
}

}  // namespace hogelscope
