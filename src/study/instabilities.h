// SPDX-License-Identifier: BSD-3-Clause
// Instabilities other than the lens: leakage, averages of PSNRs, an eye near the panel, grazing
// rays, scenes much smaller or larger than a metre.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/lens/lens_table.h"

namespace hogelscope {

/// A row of stability.csv. The meaning of x, y and value depends on the kind:
///
/// | kind          | x                        | y               | value                       |
/// | psf_gain      | sigma                    | windowSize      | white over white            |
/// | psnr_mean     | views                    | identical views | dB                          |
/// | near_panel    | the eye's distance, m    |                 | share of pixels that differ |
/// | grazing       | degrees off the axis     |                 | share of pixels that differ |
/// | scale, origin | a factor; metres         |                 | share of pixels that differ |
/// | pupil_focus   | the distance of focus, m | samples         | share of pixels that differ |
/// | pupil_width   | the pupil's diameter, m  | samples         | share of pixels that differ |
/// | undistortion  | factor of the lens       |                 | dB                          |
struct InstabilityRow {
  std::string kind;
  std::string method;
  double x = 0;
  std::optional<double> y;
  std::optional<std::size_t> points;  ///< pixels that either image sees
  double value = 0;
};

/// Measures the value of a white hogel's inner directional pixel: "normalised" as simulated, "paper
/// eq. 5" as the plain sum of the Gaussian density's samples, Σ exp(-(x²+y²)/(2σ²)) / (2πσ²).
std::vector<InstabilityRow> psfGains();

/// Averages six views at 35.0 dB, some replaced by identical ones: "mean of cv::PSNR" counts an
/// identical one as 361 dB; "mean of finite" and "of mean MSE" are the report's.
std::vector<InstabilityRow> psnrMeans();

/// Measures how many pixels of a view of numbered directional pixels differ from the
/// reference engine's image: by the "fast engine", in "float" (all geometry in single precision),
/// and from an "eye 10 um aside", which gives the sensitivity to the eye's position.
/// - near_panel: the eye in front of the panel's middle.
/// - grazing: the eye at the paper's distance, off the panel's axis.
/// - scale: panel, eye and distance scaled by x; origin: all shifted by x metres along each axis
///   of the world. Both are compared with the image of the original scene.
/// - pupil_focus: a pupil of 4 mm at the paper's distance that focuses ever nearer; pupil_width:
/// ever
///   wider pupils that focus on the panel. In them a pixel differs if a value does by more than 1.
std::vector<InstabilityRow> viewErrors(const ParallelRows& parallelRows, const Progress& progress);

/// Measures all instabilities. Throws Cancelled.
std::vector<InstabilityRow> measureInstabilities(const ParallelRows& parallelRows,
                                                 const Progress& progress);

}  // namespace hogelscope
