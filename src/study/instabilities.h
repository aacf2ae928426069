// SPDX-License-Identifier: BSD-3-Clause
// The unstable places beside the lens: leakage, averages of PSNRs, an eye near the panel, grazing
// rays, scenes far from a metre.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/lens/lens_table.h"

namespace hogelscope {

/// A row of stability.csv. What x, y and value are depends on the kind:
///
/// | kind          | x                        | y               | value                       |
/// | psf_gain      | sigma                    | windowSize      | white over white            |
/// | psnr_mean     | views                    | identical views | dB                          |
/// | near_panel    | the eye's distance, m    |                 | share of pixels gone astray |
/// | grazing       | degrees off the axis     |                 | share of pixels gone astray |
/// | scale, origin | a factor; metres         |                 | share of pixels gone astray |
struct InstabilityRow {
  std::string kind;
  std::string method;
  double x = 0;
  std::optional<double> y;
  std::optional<std::size_t> points;  ///< pixels that either picture sees
  double value = 0;
};

/// What a white hogel's inner directional pixel becomes: "normalised" by the simulation itself,
/// "paper eq. 5" the bare sum of the Gaussian density's samples, Σ exp(-(x²+y²)/(2σ²)) / (2πσ²).
std::vector<InstabilityRow> psfGains();

/// Six views at 35.0 dB of which some are identical, averaged: "mean of cv::PSNR" takes 361 dB for
/// an identical one; "mean of finite" and "of mean MSE" are the report's.
std::vector<InstabilityRow> psnrMeans();

/// How many pixels of a view of numbered directional pixels show another one than the reference
/// engine's picture does: by the "fast engine", in "float" (all geometry in single precision), and
/// from an "eye 10 um aside", which says how well the eye must be known.
/// - near_panel: the eye in front of the panel's middle.
/// - grazing: the eye at the paper's distance, off the panel's axis.
/// - scale: panel, eye and distance x times as large; origin: all x metres along each axis away
/// from
///   the world's origin. Both against the picture of the scene as it was.
std::vector<InstabilityRow> viewErrors(const ParallelRows& parallelRows, const Progress& progress);

/// All of them. Throws Cancelled.
std::vector<InstabilityRow> measureInstabilities(const ParallelRows& parallelRows,
                                                 const Progress& progress);

}  // namespace hogelscope
