// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/raw_plane.h"

#include <string>

#include "core/base/error.h"

namespace hogelscope {

std::vector<std::uint16_t> readRow(const RandomAccessFile& file, const RawPlane& plane,
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

}  // namespace hogelscope
