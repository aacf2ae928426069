// SPDX-License-Identifier: BSD-3-Clause
// Uncompressed samples in a file.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/error.h"
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
inline std::vector<std::uint16_t> readRow(const RandomAccessFile& file, const RawPlane& plane,
                                          std::uint64_t y) {
  std::vector<std::uint8_t> bytes(plane.rowBytes());
  file.read(plane.at + y * plane.rowBytes(), std::as_writable_bytes(std::span(bytes)));
  std::vector<std::uint16_t> samples(plane.width);
  const int values = 1 << plane.bits;
  const bool isWide = plane.bits > 8;
  for (std::size_t x = 0; x < samples.size(); ++x) {
    const std::size_t first = isWide ? 2 * x : x;
    int sample = bytes[first];
    if (isWide)
      sample =
          plane.isBigEndian ? 256 * sample + bytes[first + 1] : sample + 256 * bytes[first + 1];
    if (plane.isSigned) {
      const int container = isWide ? 1 << 16 : 1 << 8;
      sample += values / 2 - (sample < container / 2 ? 0 : container);
    }
    if (sample < 0 || sample >= values)
      throw InputError(file.path().string(),
                       "sample (" + std::to_string(x) + ", " + std::to_string(y) + ")",
                       "has more than " + std::to_string(plane.bits) + " bits");
    samples[x] = std::uint16_t(sample);
  }
  return samples;
}

/// Scales a value of `bits` bits to the full range of T: the largest becomes T's largest, others
/// are rounded.
template <class T>
T spread(std::uint32_t value, int bits) {
  const std::uint64_t most = (std::uint64_t{1} << unsigned(bits)) - 1;
  return T((std::uint64_t{2} * value * std::uint64_t{std::numeric_limits<T>::max()} + most) /
           (2 * most));
}

}  // namespace hogelscope
