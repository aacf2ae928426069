// SPDX-License-Identifier: BSD-3-Clause
// Two codecs in two numbers: Bjøntegaard's deltas between their rate-distortion curves.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

/// One point of a curve: bits per directional pixel, and a quality such as a PSNR in dB.
struct RatePoint {
  double rate = 0;
  double quality = 0;
};

/// Not numbers where `problem` says why.
struct BdDelta {
  double rate = 0;     ///< BD-rate in percent: the bits that the test needs more at equal quality
  double quality = 0;  ///< BD-PSNR in dB, BD-SSIM, …: what the test is better by at equal rate
  double from = 0;
  double to = 0;  ///< the qualities that both curves reach
  std::string problem;
};

/// Bjøntegaard, VCEG-M33, between curves of log10(rate) and quality that go through their points as
/// monotone piecewise cubics (Fritsch and Butland 1984; the PCHIP of MATLAB, SciPy and JVET's
/// spreadsheet), rather than as one cubic, which may fall between points, and misses them if there
/// are more than four. Each curve needs four points or more whose quality rises with the rate.
BdDelta bdDelta(std::vector<RatePoint> anchor, std::vector<RatePoint> test);

/// Integral over [from, to] ⊆ [x.front(), x.back()] of the monotone piecewise cubic through the
/// points; x rises strictly, two points at least.
double pchipIntegral(const std::vector<double>& x, const std::vector<double>& y, double from,
                     double to);

}  // namespace hogelscope
