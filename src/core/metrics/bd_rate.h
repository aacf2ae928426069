// SPDX-License-Identifier: BSD-3-Clause
// Two codecs in two numbers: Bjøntegaard's deltas between their rate-distortion curves.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

/// One point of a curve: bits per directional pixel, PSNR in dB.
struct RatePoint {
  double rate = 0;
  double psnr = 0;
};

/// Not numbers where `problem` says why.
struct BdDelta {
  double rate = 0;  ///< BD-rate in percent: the bits that the test needs more at equal PSNR
  double psnr = 0;  ///< BD-PSNR in dB: what the test is better by at equal rate
  double psnrFrom = 0;
  double psnrTo = 0;  ///< the PSNRs that both curves reach
  std::string problem;
};

/// Bjøntegaard, VCEG-M33, between curves of log10(rate) and PSNR that go through their points as
/// monotone piecewise cubics (Fritsch and Butland 1984; the PCHIP of MATLAB, SciPy and JVET's
/// spreadsheet), rather than as one cubic, which may fall between points, and misses them if there
/// are more than four. Each curve needs four points or more whose PSNR rises with the rate.
BdDelta bdDelta(std::vector<RatePoint> anchor, std::vector<RatePoint> test);

/// Integral over [from, to] ⊆ [x.front(), x.back()] of the monotone piecewise cubic through the
/// points; x rises strictly, two points at least.
double pchipIntegral(const std::vector<double>& x, const std::vector<double>& y, double from,
                     double to);

}  // namespace hogelscope
