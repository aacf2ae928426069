// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/window_plots.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace hogelscope {

namespace {

/// Returns a point without its place; `row` is in the table.
Plot::Point pointOf(const std::vector<ReportRow>& rows, std::size_t row) {
  Plot::Point point;
  point.row = row;
  point.up = rows[row].values[psnrSeenColumn];
  point.name = viewName(rows[row]) + "  " + rounded(point.up, 1) + " dB";
  return point;
}

bool hasFigure(const ReportRow& row) {
  return row.problem.empty() && !std::isnan(row.values[psnrSeenColumn]);
}

}  // namespace

std::vector<std::string> curvesOf(const std::vector<PlottedTest>& tests) {
  std::vector<std::string> curves;
  for (const PlottedTest& test : tests)
    if (std::ranges::find(curves, test.curve) == curves.end()) curves.push_back(test.curve);
  return curves;
}

Plot meanPlot(const std::vector<PlottedTest>& tests, const std::vector<TestSummary>& summaries) {
  Plot plot;
  plot.isLogarithmic =
      std::ranges::all_of(tests, [](const PlottedTest& test) { return test.rate > 0; });
  plot.titleAcross = plot.isLogarithmic ? "bits per directional pixel" : "test";
  plot.titleUp = "Mean PSNR over what is seen, dB";
  plot.leastRange = plot.isLogarithmic ? std::array{1e-3, 0.5} : std::array{0.5, 0.5};
  plot.hasCurves = true;
  for (const std::string& curve : curvesOf(tests)) plot.series.push_back({curve, {}});
  for (std::size_t k = 0; k < tests.size() && k < summaries.size(); ++k) {
    const double mean = summaries[k].summary.means[meanPsnrSeen];
    if (!std::isfinite(mean)) continue;
    Plot::Point point{plot.isLogarithmic ? std::log10(tests[k].rate) : 1 + double(k), mean, "", k,
                      summaries[k].intervals[meanPsnrSeen]};
    point.name = tests[k].name + "  " + rounded(mean, 2) + " dB";
    std::ranges::find(plot.series, tests[k].curve, &Plot::Series::name)->points.push_back(point);
  }
  for (Plot::Series& series : plot.series)
    std::ranges::sort(series.points, {}, &Plot::Point::across);
  return plot;
}

Plot eyeMap(const std::vector<ReportRow>& rows, std::size_t test, std::size_t tests,
            const DisplayParams& display) {
  Plot plot;
  plot.titleAcross = "panel, " + numberText(fourDigits(display.size[0])) + " m";
  plot.titleUp = "Eyes from above, m";
  plot.panel = display.size[0];
  plot.series.resize(1);
  for (std::size_t row = test; row < rows.size(); row += tests) {
    if (!hasFigure(rows[row])) continue;
    Plot::Point point = pointOf(rows, row);
    const Vec3 eye = eyePlaceOf(display, rows[row].eye).point;
    point.shade = point.up;
    point.across = eye.x;
    point.up = eye.z;
    if (std::isfinite(point.shade)) {
      if (!plot.shades) plot.shades = Axis{point.shade, point.shade};
      plot.shades->low = std::min(plot.shades->low, point.shade);
      plot.shades->high = std::max(plot.shades->high, point.shade);
    }
    plot.series[0].points.push_back(point);
  }
  // The worst is drawn last, on top.
  std::ranges::stable_sort(plot.series[0].points, std::ranges::greater(), &Plot::Point::shade);
  if (plot.shades && !(plot.shades->high > plot.shades->low)) plot.shades->high += 1;
  return plot;
}

Plot windowPlot(const std::vector<ReportRow>& rows, std::size_t test, std::size_t tests,
                const std::vector<CameraState>& states) {
  Plot plot;
  plot.titleAcross = "leakage window, px";
  plot.titleUp = "PSNR, dB";
  plot.leastRange = {1, 0.5};
  plot.series.resize(1);
  for (std::size_t row = test; row < rows.size() && row / tests < states.size(); row += tests) {
    if (!hasFigure(rows[row])) continue;
    Plot::Point point = pointOf(rows, row);
    point.across = states[row / tests].psf.windowSize;
    plot.series[0].points.push_back(point);
  }
  return plot;
}

}  // namespace hogelscope
