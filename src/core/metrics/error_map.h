// SPDX-License-Identifier: BSD-3-Clause
// The error of a test image against its reference as an image, with a choice of error, gain and
// colours, and their difference as an image.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/optics/image.h"

namespace hogelscope {

/// The error of code values r of the reference and t of the test, 0 … 255.
enum class ErrorKind {
  absolute,     ///< |t − r|
  signedError,  ///< t − r
  squared,      ///< (t − r)²
  relative,     ///< 100 |t − r| / max(r, 1), in percent
  luma          ///< |Y(t) − Y(r)|, Y of BT.709; one value per pixel
};

/// Returns the error of one channel; for `luma`, that of a grey pixel.
double errorOf(ErrorKind kind, double reference, double test);
/// Returns the error of a pixel: for `luma` its own, otherwise the mean of the three channels.
double pixelError(ErrorKind kind, std::span<const std::uint8_t, 3> reference,
                  std::span<const std::uint8_t, 3> test);

/// The display tone: values are limited to 1 after the gain, then raised to 1/gamma.
struct Tone {
  double gain = 1;
  double gamma = 1;
  bool operator==(const Tone&) const = default;
};

/// Returns the shown value of each code value.
std::array<std::uint8_t, 256> toneTable(const Tone& tone);

/// Maps errors to colours. Errors of 255/gain (in code values; for `squared` the square of that,
/// for `relative` 100/gain percent) are shown brightest. Signed errors are shown in both directions
/// from 0 in the middle. Without false colour, all three channels are shown.
class ErrorMap {
 public:
  struct Params {
    ErrorKind kind = ErrorKind::absolute;
    Tone tone{.gain = 4};
    bool hasFalseColour = false;
    bool operator==(const Params&) const = default;
  };

  explicit ErrorMap(const Params& params);

  /// Writes the map of RGB values; all three have the same length.
  void write(std::span<const std::uint8_t> reference, std::span<const std::uint8_t> test,
             std::span<std::uint8_t> result) const;
  /// Returns the error at a position 0 … 1 of the colour scale.
  [[nodiscard]] double errorAt(double place) const;
  /// Returns the position of an error on the colour scale: the inverse of errorAt(), limited to
  /// 0 … 1.
  [[nodiscard]] double placeOf(double error) const;
  [[nodiscard]] std::array<std::uint8_t, 3> colourAt(double place) const;

 private:
  Params m_params;
  double m_full;                         ///< the error shown brightest
  std::vector<std::uint8_t> m_channels;  ///< indexed by reference and test, 256 × 256
  std::array<std::array<std::uint8_t, 3>, 256> m_colours{};
};

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
