// SPDX-License-Identifier: BSD-3-Clause
// Bjøntegaard's deltas between the rate-distortion curves of two codecs.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

/// A point of a curve: bits per directional pixel, and a quality such as a PSNR in dB.
struct RatePoint {
  double rate = 0;
  double quality = 0;
};

/// Bjøntegaard's deltas; NaN if there is a `problem`.
struct BdDelta {
  double rate = 0;     ///< BD-rate in percent: additional bits of the test at equal quality
  double quality = 0;  ///< BD-PSNR in dB, BD-SSIM, …: gain of the test at equal rate
  double from = 0;
  double to = 0;  ///< the range of qualities reached by both curves
  std::string problem;
};

/// Computes Bjøntegaard's deltas (VCEG-M33) between curves of log10(rate) and quality. The curves
/// are monotone piecewise cubics through the points (Fritsch and Butland 1984; the PCHIP of MATLAB,
/// SciPy and JVET's spreadsheet), not single cubics, which may fall between points and miss more
/// than four of them. Each curve needs at least four points whose quality rises with the rate.
BdDelta bdDelta(std::vector<RatePoint> anchor, std::vector<RatePoint> test);

/// Whether the quality falls with each higher rate, as that of an error does. False for fewer than
/// two points.
bool doesFall(std::vector<RatePoint> curve);

/// Returns the integral over [from, to] ⊆ [x.front(), x.back()] of the monotone piecewise cubic
/// through the points. x rises strictly and has at least two points.
double pchipIntegral(const std::vector<double>& x, const std::vector<double>& y, double from,
                     double to);

}  // namespace hogelscope
