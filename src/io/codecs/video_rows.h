// SPDX-License-Identifier: BSD-3-Clause
// The arithmetic of a row of a video's samples, for many samples at a time. No step is fused, so
// that values do not depend on the machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hogelscope {

/// The conversion of samples Y, Cb, Cr to values, each from 0 to 2^bits − 1.
struct YuvWeights {
  float black = 0;
  float luma = 1;
  float middle = 0;
  float crToRed = 0;
  float cbToGreen = 0;
  float crToGreen = 0;
  float cbToBlue = 0;
};

/// Copies samples that follow each other.
void copySamples(const std::uint8_t* from, std::size_t count, float* to);
void copySamples(const std::uint16_t* from, std::size_t count, float* to);

/// Makes red, green and blue of Y, Cb and Cr, in place.
void yuvToRgb(const YuvWeights& weights, std::size_t count, float* y, float* cb, float* cr);

/// Rounds values half up after they are limited to 0 … `most`, and writes them as red, green and
/// blue of pixels.
void writePixels(const float* red, const float* green, const float* blue, std::size_t count,
                 float most, std::uint8_t* rgb);
void writePixels(const float* red, const float* green, const float* blue, std::size_t count,
                 float most, std::uint16_t* rgb);

}  // namespace hogelscope
