// SPDX-License-Identifier: BSD-3-Clause
// The time and error of a method: a row of tradeoff.csv, a point of the chart.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hogelscope {

struct TradeoffRow {
  std::string method;          ///< short and unique
  std::string lens;            ///< such as "exact", "direct", "fixed point 5", "table 8 px"
  std::string reconstruction;  ///< "nearest", "bilinear" or "quadrilinear"
  std::string psf;             ///< "full", "truncated" or "off"
  int samples = 1;             ///< per pixel, along each side
  int scale = 1;               ///< 2: half resolution, scaled up
  std::string precision;       ///< "double" or "float"
  double milliseconds = 0;     ///< per image, median of the runs
  double fastest = 0;          ///< milliseconds of the fastest run
  double upperQuartile = 0;    ///< upper quartile, milliseconds
  double lowerQuartile = 0;    ///< lower quartile, milliseconds
  int runs = 0;
  double timedPixels = 0;  ///< pixels rendered by a run, over the timed states
  double mraysPerSecond = 0;
  double rmse = 0;          ///< code values of 8-bit images, over all states, pixels and channels
  double psnr = 0;          ///< dB; infinite if rmse is 0
  double maxError = 0;      ///< code values
  double seenMismatch = 0;  ///< share of the pixels that are seen in only one of the images
  double errorPixels = 0;   ///< pixels compared, over the states
  bool isSampled = false;   ///< its time or its error was measured on part of the pixels
  bool isPareto = false;    ///< no other row is as fast and as accurate, and better in one of them
  bool isDefault = false;   ///< the program's default
};

/// Sets the times from `runs` (at least one) in milliseconds per image.
void setTimes(TradeoffRow& row, std::vector<double> runs);

/// Returns the half width of the median's 95 % interval relative to the median: 1.57 times the
/// interquartile range over the root of the number of runs (McGill, Tukey and Larsen 1978). NaN for
/// one run.
double spreadOf(const TradeoffRow& row);

}  // namespace hogelscope
