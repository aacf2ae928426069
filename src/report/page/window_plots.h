// SPDX-License-Identifier: BSD-3-Clause
// Plots of a report that only the window has. Rows are in ReportOrder; those with a problem have no
// point.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/summary.h"
#include "core/optics/session.h"
#include "page/plot.h"

namespace hogelscope {

/// A test in the window: its short name, and the curve that it is a point of.
struct PlottedTest {
  std::string name;
  std::string curve;
  double rate = 0;  ///< bits per directional pixel; NaN: unknown
};

/// Returns the curves of the tests, in the order in which they first occur.
std::vector<std::string> curvesOf(const std::vector<PlottedTest>& tests);

/// Returns each test's mean PSNR with its interval over the rate, or over the tests, from 1, if one
/// has no rate. The row of a point is the test's number.
Plot meanPlot(const std::vector<PlottedTest>& tests, const std::vector<TestSummary>& summaries);

/// Returns the eyes of one test from above, in the display frame, coloured by PSNR.
Plot eyeMap(const std::vector<ReportRow>& rows, std::size_t test, std::size_t tests,
            const DisplayParams& display);

/// Returns the PSNR of one test over the leakage window of `states`.
Plot windowPlot(const std::vector<ReportRow>& rows, std::size_t test, std::size_t tests,
                const std::vector<CameraState>& states);

}  // namespace hogelscope
