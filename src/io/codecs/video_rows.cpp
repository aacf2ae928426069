// SPDX-License-Identifier: BSD-3-Clause
#include "io/codecs/video_rows.h"

#include <algorithm>
#include <array>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

/// Rounds half up and converts by way of int, for which all machines have an instruction.
template <class T>
void roundValues(const float* values, std::size_t count, float most, T* to) {
  for (std::size_t k = 0; k < count; ++k) {
    const float limited = values[k] < 0 ? 0 : values[k] > most ? most : values[k];
    to[k] = static_cast<T>(static_cast<int>(limited + 0.5F));
  }
}

MULTIVERSIONED void roundRow(const float* values, std::size_t count, float most, std::uint8_t* to) {
  roundValues(values, count, most, to);
}

MULTIVERSIONED void roundRow(const float* values, std::size_t count, float most,
                             std::uint16_t* to) {
  roundValues(values, count, most, to);
}

template <class T>
void writeRows(const std::array<const float*, 3>& rows, std::size_t count, float most, T* rgb) {
  constexpr std::size_t atOnce = 256;
  std::array<std::array<T, atOnce>, 3> rounded;
  for (std::size_t first = 0; first < count; first += atOnce) {
    const std::size_t end = std::min(count - first, atOnce);
    for (std::size_t c = 0; c < 3; ++c) roundRow(rows[c] + first, end, most, rounded[c].data());
    for (std::size_t k = 0; k < end; ++k, rgb += 3) {
      rgb[0] = rounded[0][k];
      rgb[1] = rounded[1][k];
      rgb[2] = rounded[2][k];
    }
  }
}

}  // namespace

MULTIVERSIONED void copySamples(const std::uint8_t* from, std::size_t count, float* to) {
  for (std::size_t k = 0; k < count; ++k) to[k] = from[k];
}

MULTIVERSIONED void copySamples(const std::uint16_t* from, std::size_t count, float* to) {
  for (std::size_t k = 0; k < count; ++k) to[k] = from[k];
}

MULTIVERSIONED void yuvToRgb(const YuvWeights& weights, std::size_t count, float* __restrict y,
                             float* __restrict cb, float* __restrict cr) {
  const YuvWeights w = weights;
  for (std::size_t k = 0; k < count; ++k) {
    const float luma = w.luma * (y[k] - w.black);
    const float blue = cb[k] - w.middle;
    const float red = cr[k] - w.middle;
    y[k] = luma + w.crToRed * red;
    cb[k] = luma + w.cbToGreen * blue + w.crToGreen * red;
    cr[k] = luma + w.cbToBlue * blue;
  }
}

void writePixels(const float* red, const float* green, const float* blue, std::size_t count,
                 float most, std::uint8_t* rgb) {
  writeRows<std::uint8_t>({red, green, blue}, count, most, rgb);
}

void writePixels(const float* red, const float* green, const float* blue, std::size_t count,
                 float most, std::uint16_t* rgb) {
  writeRows<std::uint16_t>({red, green, blue}, count, most, rgb);
}

}  // namespace hogelscope
