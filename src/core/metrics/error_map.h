// SPDX-License-Identifier: BSD-3-Clause
// The error of a test image against its reference, pixel for pixel, as an image: which error, how
// bright, and in which colours.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hogelscope {

/// Of code values r of the reference and t of the test, 0 … 255.
enum class ErrorKind {
  absolute,     ///< |t − r|
  signedError,  ///< t − r
  squared,      ///< (t − r)²
  relative,     ///< 100 |t − r| / max(r, 1), in percent
  luma          ///< |Y(t) − Y(r)|, Y of BT.709; one value a pixel
};

/// Returns the error of one channel; of `luma`, that of a grey pixel.
double errorOf(ErrorKind kind, double reference, double test);
/// Returns the error of a pixel: of `luma` its own, of the others the mean of the three channels.
double pixelError(ErrorKind kind, std::span<const std::uint8_t, 3> reference,
                  std::span<const std::uint8_t, 3> test);

/// How light is shown: limited to 1 after the gain, then raised to 1/gamma.
struct Tone {
  double gain = 1;
  double gamma = 1;
  bool operator==(const Tone&) const = default;
};

/// Returns what each code value is shown as.
std::array<std::uint8_t, 256> toneTable(const Tone& tone);

/// The gain is one of code values: errors of 255/gain, or their square, or 100/gain percent, are
/// shown brightest. Signed errors are shown from the middle, 0, both ways; without false colour
/// all three channels are shown.
class ErrorMap {
 public:
  struct Params {
    ErrorKind kind = ErrorKind::absolute;
    Tone tone{.gain = 8};
    bool hasFalseColour = false;
    bool operator==(const Params&) const = default;
  };

  explicit ErrorMap(const Params& params);

  /// Writes the map of RGB values; all three have the same length.
  void write(std::span<const std::uint8_t> reference, std::span<const std::uint8_t> test,
             std::span<std::uint8_t> result) const;
  /// Returns the error that is shown by place 0 … 1 of the scale of colours.
  [[nodiscard]] double errorAt(double place) const;
  [[nodiscard]] std::array<std::uint8_t, 3> colourAt(double place) const;

 private:
  [[nodiscard]] double placeOf(double error) const;

  Params m_params;
  double m_full;                         ///< the error that is shown brightest
  std::vector<std::uint8_t> m_channels;  ///< by reference and test, 256 × 256
  std::array<std::array<std::uint8_t, 3>, 256> m_colours{};
};

}  // namespace hogelscope
