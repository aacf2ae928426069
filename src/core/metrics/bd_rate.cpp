// SPDX-License-Identifier: BSD-3-Clause
// Bjøntegaard's deltas by monotone piecewise cubics.
#include "core/metrics/bd_rate.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

namespace {

/// Returns the slope at an end: that of the parabola through three points, limited to keep the
/// curve's shape.
double endSlope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  if (d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
  return slope;
}

/// Returns the slope at each point; inside, the weighted harmonic mean of both sides, or 0 at a
/// peak.
std::vector<double> slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t last = x.size() - 1;
  const auto h = [&](std::size_t k) { return x[k + 1] - x[k]; };
  const auto d = [&](std::size_t k) { return (y[k + 1] - y[k]) / h(k); };
  if (last == 1) return {d(0), d(0)};
  std::vector<double> m(x.size());
  m[0] = endSlope(h(0), h(1), d(0), d(1));
  m[last] = endSlope(h(last - 1), h(last - 2), d(last - 1), d(last - 2));
  for (std::size_t k = 1; k < last; ++k) {
    if (d(k - 1) * d(k) <= 0) continue;
    const double w1 = 2 * h(k) + h(k - 1);
    const double w2 = h(k) + 2 * h(k - 1);
    m[k] = (w1 + w2) / (w1 / d(k - 1) + w2 / d(k));
  }
  return m;
}

/// A curve as two columns; `x` is the variable of integration.
struct Curve {
  std::vector<double> x, y;
};

/// Returns the mean of test − anchor over their common range, or NaN.
double meanDifference(const Curve& anchor, const Curve& test) {
  const double from = std::max(anchor.x.front(), test.x.front());
  const double to = std::min(anchor.x.back(), test.x.back());
  if (!(from < to)) return unknownFigure;
  return (pchipIntegral(test.x, test.y, from, to) - pchipIntegral(anchor.x, anchor.y, from, to)) /
         (to - from);
}

Curve columns(const std::vector<RatePoint>& points, bool isOverQuality) {
  Curve curve;
  for (const RatePoint& point : points) {
    curve.x.push_back(isOverQuality ? point.quality : std::log10(point.rate));
    curve.y.push_back(isOverQuality ? std::log10(point.rate) : point.quality);
  }
  return curve;
}

void sortByRate(std::vector<RatePoint>& points) {
  std::ranges::sort(points, {}, &RatePoint::rate);
}

/// Sorts by rate. Returns the problem of a curve, or "".
std::string problemOf(std::vector<RatePoint>& points, const std::string& name) {
  if (points.size() < 4)
    return name + " has " + std::to_string(points.size()) + " points, but four are needed";
  for (const RatePoint& point : points) {
    if (!(point.rate > 0) || !std::isfinite(point.rate))
      return name + " has a rate of " + numberText(point.rate) + ", not a positive number";
    if (!std::isfinite(point.quality))
      return name + " has no finite quality at a rate of " + numberText(point.rate);
  }
  sortByRate(points);
  for (std::size_t k = 1; k < points.size(); ++k)
    if (points[k].rate == points[k - 1].rate || !(points[k].quality > points[k - 1].quality))
      return name + "'s quality does not rise from a rate of " + numberText(points[k - 1].rate) +
             " to " + numberText(points[k].rate);
  return {};
}

}  // namespace

double pchipIntegral(const std::vector<double>& x, const std::vector<double>& y, double from,
                     double to) {
  const std::vector<double> m = slopes(x, y);
  double sum = 0;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const double a = std::max(from, x[k]);
    const double b = std::min(to, x[k + 1]);
    if (!(a < b)) continue;
    // The antiderivative of y[k] + t (m[k] + t (c2 + t c3)), t = x − x[k].
    const double h = x[k + 1] - x[k];
    const double d = (y[k + 1] - y[k]) / h;
    const double c2 = (3 * d - 2 * m[k] - m[k + 1]) / h;
    const double c3 = (m[k] + m[k + 1] - 2 * d) / (h * h);
    const auto until = [&](double t) {
      return t * (y[k] + t * (m[k] / 2 + t * (c2 / 3 + t * c3 / 4)));
    };
    sum += until(b - x[k]) - until(a - x[k]);
  }
  return sum;
}

bool doesFall(std::vector<RatePoint> curve) {
  sortByRate(curve);
  for (std::size_t k = 1; k < curve.size(); ++k)
    if (!(curve[k].quality < curve[k - 1].quality)) return false;
  return curve.size() > 1;
}

BdDelta bdDelta(std::vector<RatePoint> anchor, std::vector<RatePoint> test) {
  BdDelta delta{unknownFigure, unknownFigure, unknownFigure, unknownFigure,
                problemOf(anchor, "the anchor")};
  if (delta.problem.empty()) delta.problem = problemOf(test, "the test");
  if (!delta.problem.empty()) return delta;
  const double from = std::max(anchor.front().quality, test.front().quality);
  const double to = std::min(anchor.back().quality, test.back().quality);
  if (!(from < to)) {
    delta.problem = "the qualities do not overlap: " + numberText(anchor.front().quality) + " to " +
                    numberText(anchor.back().quality) + ", and " +
                    numberText(test.front().quality) + " to " + numberText(test.back().quality);
    return delta;
  }
  const double logRate = meanDifference(columns(anchor, true), columns(test, true));
  delta.rate = 100 * (std::pow(10, logRate) - 1);
  delta.quality = meanDifference(columns(anchor, false), columns(test, false));
  delta.from = from;
  delta.to = to;
  if (std::isnan(delta.quality))
    delta.problem = "the rates do not overlap: no difference of quality";
  return delta;
}

}  // namespace hogelscope
