// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/depth_budget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/panel/design_numbers.h"

namespace hogelscope {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

void describe(ParameterVisitor& v, DepthParams& p) {
  auto& [share, comfort, ipd, pupil] = p;
  v.group("depth", "Whether content fits the display (--depth).");
  v.field("share", share, {0.01, 1, 0.01}, "",
          "Part of the content's pixels that should lie within the limits.");
  v.field("comfort", comfort, {0.01, 60, 0.1}, "°",
          "Largest disparity between the eyes that is comfortable.");
  v.field("ipd", ipd, {0.001, 1, 0.001}, "m",
          "Distance between the pupils, for states whose stereo.ipd is 0.");
  v.field("pupil", pupil, {0.0001, 0.1, 0.001}, "m",
          "Diameter of the pupil, for states whose pupil.diameter is 0.");
}

double depthAt(double dioptres, double distance) {
  const double vergence = dioptres + 1 / distance;
  return vergence > 0 ? distance - 1 / vergence : -infinite;
}

DepthRange DepthLimits::inMetres(double limit) const {
  return {depthAt(limit, distance), -depthAt(-limit, distance)};
}

double DepthLimits::disparityOf(double dioptres) const {
  return dioptres == 0 ? 0 : -dioptres / display;
}

double DepthLimits::mismatchOf(double dioptres) const {
  return directionsPerPupil < 1 ? std::abs(dioptres) : 0;
}

DepthLimits depthLimits(const PanelParams& display, double distance, const DepthParams& params) {
  PanelParams untilted = display;  // an eye in front of the panel's centre
  untilted.position = untilted.orientation = {};
  const DesignNumbers numbers = designNumbers(untilted, {0, 0, distance});
  DepthLimits limits;
  limits.distance = distance;
  limits.display = infinite;
  double widest = 0;
  for (const std::size_t axis : {0, 1}) {
    if (display.directions[axis] < 2) continue;
    limits.display = std::min(
        limits.display, numbers.hogelPitch[axis] / (numbers.slopeStep[axis] * distance * distance));
    widest = std::max(widest, numbers.slopeStep[axis]);
  }
  limits.comfort = params.comfort * std::numbers::pi / 180 / params.ipd;
  limits.directionsPerPupil = widest > 0 ? params.pupil / (distance * widest) : 0;
  return limits;
}

std::array<double, 2> shortestInterval(std::span<const double> sorted, double share) {
  const std::size_t count = sorted.size();
  // The tolerance keeps share·count, where it is a whole number, from being rounded up to the next.
  const auto least = std::size_t(std::ceil(share * double(count) * (1 - 1e-12)));
  const std::size_t span = std::clamp(least, std::size_t{1}, count) - 1;
  std::array<double, 2> best{sorted.front(), sorted.back()};
  for (std::size_t k = 0; k + span < count; ++k)
    if (sorted[k + span] - sorted[k] < best[1] - best[0]) best = {sorted[k], sorted[k + span]};
  return best;
}

DepthFit fitDepths(double back, double front, double behind, double before) {
  if (front - back <= behind + before) {
    const double least = front - before;
    const double most = back + behind;
    return {1, std::max(least, std::min(0.0, most))};
  }
  return {(behind + before) / (front - back), (behind * front + before * back) / (behind + before)};
}

}  // namespace hogelscope
