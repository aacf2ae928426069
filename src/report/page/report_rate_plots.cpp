// SPDX-License-Identifier: BSD-3-Clause
// Rate–distortion plots: quality over bits per directional pixel, a curve for each group of tests.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/colour_map.h"
#include "core/base/text.h"
#include "report/page/html.h"
#include "report/page/plot.h"
#include "report/page/report_plots.h"

namespace hogelscope {

namespace {

/// A test's mean at its rate.
struct CurvePoint {
  const TestSummary* test;
  double rate;
  double value;
  Interval interval;
};

using Curve = std::vector<CurvePoint>;

/// The finite points of a group, from the lowest rate on.
Curve curveOf(const RateGroup& group, const std::vector<TestSummary>& summaries, std::size_t mean) {
  Curve curve;
  for (const TestRate& rate : group.tests)
    for (const TestSummary& test : summaries)
      if (test.test == rate.test && std::isfinite(test.summary.means[mean]))
        curve.push_back({&test, rate.rate, test.summary.means[mean], test.intervals[mean]});
  std::ranges::sort(curve, {}, &CurvePoint::rate);
  return curve;
}

/// Out to the points and to their intervals, with some room.
void fit(Axis& across, Axis& up, const std::vector<Curve>& curves) {
  across.low = up.low = std::numeric_limits<double>::infinity();
  across.high = up.high = -up.low;
  for (const Curve& curve : curves)
    for (const CurvePoint& point : curve) {
      across.low = std::min(across.low, std::log10(point.rate));
      across.high = std::max(across.high, std::log10(point.rate));
      up.low = std::min(up.low, point.interval.low);
      up.high = std::max(up.high, point.interval.high);
    }
  for (Axis* axis : {&across, &up}) {
    const double room = std::max(0.05 * (axis->high - axis->low), 1e-3);
    axis->low -= room;
    axis->high += room;
  }
}

/// "a.jpg: 0.25 bits, 31.20 (30.95 … 31.44)".
std::string titleOf(const CurvePoint& point, const MetricMean& mean) {
  const auto number = [&](double value) { return rounded(value, mean.decimals); };
  return "<title>" + escaped(point.test->test) + ": " + numberText(point.rate) + " bits, " +
         number(point.value) + " (" + number(point.interval.low) + " … " +
         number(point.interval.high) + ")</title>";
}

std::string drawn(const Curve& curve, std::size_t group, const Axis& across, const Axis& up,
                  const MetricMean& mean) {
  const std::string colour = seriesColour(group);
  std::string line, bars, marks;
  for (const CurvePoint& point : curve) {
    const double x = across.at(std::log10(point.rate));
    const double y = up.at(point.value);
    line += (line.empty() ? "" : " ") + coordinate(x) + "," + coordinate(y);
    bars += svgLine(x, up.at(point.interval.low), x, up.at(point.interval.high), "interval");
    marks += seriesMark(group, x, y, 4.5, "", titleOf(point, mean)) + "\n";
  }
  return "<g class=\"points\" fill=\"" + colour + "\" color=\"" + colour + "\">\n" +
         "<polyline class=\"curve\" points=\"" + line + "\"/>" + bars + "\n" + marks + "</g>\n";
}

/// At rates; on an axis of their logarithms.
std::vector<Tick> rateTicks(const Axis& across) {
  std::vector<Tick> ticks = logarithmicTicks(across, 40);
  if (std::ranges::count_if(ticks, [](const Tick& tick) { return !tick.text.empty(); }) < 2)
    ticks = linearTicks({std::pow(10, across.low), std::pow(10, across.high)}, 5);
  for (Tick& tick : ticks) tick.value = std::log10(tick.value);
  return ticks;
}

std::string plot(const std::vector<Curve>& curves, const MetricMean& mean) {
  Axis across{0, 1, 62, 364};
  Axis up{0, 1, 250, 14};
  fit(across, up, curves);
  const std::string title = mean.title + (mean.unit.empty() ? "" : " in " + mean.unit);
  std::string text = "<svg class=\"map\" viewBox=\"0 0 376 296\" role=\"img\" aria-label=\"" +
                     escaped(title) + " over rate\">" +
                     plotFrame(across, up, "bits per directional pixel", title, rateTicks(across));
  for (std::size_t group = 0; group < curves.size(); ++group)
    text += drawn(curves[group], group, across, up, mean);
  return text + "</svg>\n";
}

}  // namespace

std::string ratePlots(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                      const std::vector<RateGroup>& groups) {
  if (groups.empty()) return {};
  std::string plots;
  for (std::size_t mean = 0; mean < metrics.means().size(); ++mean) {
    const bool isOfPlugin = mean > meanPsnrYuvSeen;
    if (!metrics.means()[mean].isQuality || !(metrics.means()[mean].isSeen || isOfPlugin)) continue;
    std::vector<Curve> curves;
    curves.reserve(groups.size());
    for (const RateGroup& group : groups) curves.push_back(curveOf(group, summaries, mean));
    if (std::ranges::any_of(curves, [](const Curve& curve) { return !curve.empty(); }))
      plots += plot(curves, metrics.means()[mean]);
  }
  std::vector<std::string> names;
  names.reserve(groups.size());
  for (const RateGroup& group : groups) names.push_back(group.name);
  return "<figure><div class=\"plots\">\n" + plots + "</div>" + plotLegend(names) + "</figure>\n";
}

}  // namespace hogelscope
