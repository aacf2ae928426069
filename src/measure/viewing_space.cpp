// SPDX-License-Identifier: BSD-3-Clause
// From where a display can be seen: viewing zone, qualified viewing space, crosstalk, parallax.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/bisect.h"
#include "core/base/text.h"
#include "measure/measurement.h"

namespace hogelscope {

namespace {

std::string metres(double value) {
  return numberText(fourDigits(value)) + " m";
}

double light(double codeValue) {
  return linearFromEncoded(codeValue);
}

/// Returns the distance from the panel at which all of it is seen from its axis.
double nearestZone(const Bench& bench, std::size_t axis) {
  const PanelParams& display = bench.display();
  const double slope = std::tan(display.fov[axis] * std::numbers::pi / 360);
  // D T = (W/2) |1 − D/V|
  const double half = display.size[axis] / 2;
  const double turn = display.viewingDistance == notGiven ? 0 : half / display.viewingDistance;
  return half / (slope + turn);
}

/// Returns the share of the panel's side that an eye at `place` and `distance` sees.
double shareForm(const Bench& bench, double place, double distance, std::size_t axis) {
  const PanelParams& display = bench.display();
  const double slope = std::tan(display.fov[axis] * std::numbers::pi / 360);
  const double half = display.size[axis] / 2;
  const double turn = display.viewingDistance == notGiven ? 0 : 1 / display.viewingDistance;
  // |(e − x)/D + x/V| ≤ T is an interval of x around e/(1 − D/V).
  const double factor = 1 - distance * turn;
  if (std::abs(factor) < 1e-12) return std::abs(place) <= slope * distance ? 1 : 0;
  const double middle = place / factor;
  const double reach = slope * distance / std::abs(factor);
  const double seen = std::min(half, middle + reach) - std::max(-half, middle - reach);
  return std::max(seen, 0.0) / (2 * half);
}

/// Searches a place along an axis, from the eye on, where `isIn` ends; halves the last step.
template <class IsIn>
double endOf(double from, double step, double farthest, const IsIn& isIn) {
  double inside = from;
  while (isIn(inside + step)) {
    inside += step;
    if (std::abs(inside - from) > farthest) return std::numeric_limits<double>::infinity();
  }
  return bisect({inside, inside + step}, 30, isIn).inside;
}

void addZone(const Bench& bench, std::vector<Measurement>& all) {
  const double distance = bench.distance();
  for (const std::size_t axis : {0, 1}) {
    const bool hasForm =
        bench.isLinear(axis) && bench.display().lens == HogelLensModel::rectilinear;
    const double half = halfZone(bench, distance, axis);
    all.push_back({"viewingZone", "m", "whole panel " + axisName(axis) + " z=" + metres(distance),
                   [axis](Bench& b) {
                     const auto isIn = [&](double place) {
                       Vec3 eye{0, 0, b.distance()};
                       return shareSeen(b, movedTo(eye, place, axis)) == 1;
                     };
                     if (!isIn(0)) return 0.0;
                     const double step = b.distance() / 20;
                     return endOf(0, step, 1000 * b.distance(), isIn) -
                            endOf(0, -step, 1000 * b.distance(), isIn);
                   },
                   hasForm ? std::max(2 * half, 0.0) : noValue});
  }
  const bool hasForm = bench.display().lens == HogelLensModel::rectilinear;
  all.push_back({"viewingZone", "m", "whole panel from z",
                 [](Bench& b) {
                   const auto isIn = [&](double z) { return shareSeen(b, {0, 0, z}) == 1; };
                   double z = 1e-3 * b.distance();
                   while (!isIn(z) && z < 1e3 * b.distance()) z *= 1.5;
                   return isIn(z) ? endOf(z, -z / 60, z, isIn) : noValue;
                 },
                 hasForm ? std::max(nearestZone(bench, 0), nearestZone(bench, 1)) : noValue});
  // Seen from above.
  constexpr int columns = 41;
  constexpr int rows = 25;
  const double reach = 1.2 * std::max(distance, bench.display().size[0]);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double z = 2 * distance * (row + 0.5) / rows;
      const double x = reach * (2 * (column + 0.5) / columns - 1);
      Measurement one{
          "viewingZone", "", "share x=" + metres(x) + " z=" + metres(z), {}, noValue, x, z};
      one.simulate = [x, z](Bench& b) { return shareSeen(b, {x, 0, z}); };
      if (hasForm) one.closedForm = shareForm(bench, x, z, 0) * shareForm(bench, 0, z, 1);
      all.push_back(std::move(one));
    }
}

/// Returns the relative luminance of a white field over the whole panel.
double luminanceFrom(Bench& bench, const Vec3& eye) {
  constexpr int side = 9;
  const auto [width, height] = bench.display().size;
  double sum = 0;
  for (int row = 0; row < side; ++row) {
    const double y = height * ((row + 0.5) / side - 0.5);
    for (const BenchPoint& point : bench.look([](const plugin::Ray&) { return white; }, eye, 0,
                                              -width / 2, width / 2, side, y))
      sum += light(point.values[0]);
  }
  return sum / (side * side);
}

/// The thresholds of the qualified viewing space (Salmimaa and Järvenpää, J. SID 17, 2009).
constexpr double leastSeen = 0.95;
constexpr double leastLuminance = 0.5;
constexpr double mostCrosstalk = 0.1;

bool isQualified(Bench& bench, const Vec3& head, double ipd, double luminance) {
  return head.z > 0 && shareSeen(bench, head) >= leastSeen &&
         luminanceFrom(bench, head) >= leastLuminance * luminance &&
         crosstalk(bench, head, ipd, head.x) <= mostCrosstalk;
}

void addQualified(const Bench& bench, double ipd, std::vector<Measurement>& all) {
  const double distance = bench.distance();
  const auto measured = [ipd](Bench& b, std::size_t axis, double sign) {
    const double luminance = luminanceFrom(b, b.eye());
    const auto isIn = [&](double place) {
      Vec3 head = b.eye();
      (axis == 0 ? head.x : axis == 1 ? head.y : head.z) = place;
      return isQualified(b, head, ipd, luminance);
    };
    const double from = axis == 0 ? b.eye().x : axis == 1 ? b.eye().y : b.eye().z;
    if (!isIn(from)) return noValue;
    return endOf(from, sign * b.distance() / 20, 20 * b.distance(), isIn);
  };
  for (const std::size_t axis : {0, 1})
    all.push_back(
        {"qualifiedViewingSpace", "m", axisName(axis) + " z=" + metres(distance), [=](Bench& b) {
           const double width = measured(b, axis, 1) - measured(b, axis, -1);
           return std::isnan(width) ? 0 : width;
         }});
  all.push_back(
      {"qualifiedViewingSpace", "m", "from z", [=](Bench& b) { return measured(b, 2, -1); }});
  all.push_back(
      {"qualifiedViewingSpace", "m", "to z", [=](Bench& b) { return measured(b, 2, 1); }});
}

/// Returns the closed form of crosstalk() in the panel's middle: the leakage's weights of the
/// directions beyond the border.
double crosstalkForm(const Bench& bench, const Vec3& head, double ipd, double border) {
  const double hogel = bench.middleHogel(0);
  const Display panel(bench.display());
  const Vec3 left{head.x - ipd / 2, head.y, head.z};
  const auto hit = panel.intersectPlane(left, Vec3{hogel, 0, 0} - left);
  if (!hit) return noValue;
  const int seen = int(std::floor(hit->u));
  const std::vector<double> weights = bench.weights();
  const int reach = int(weights.size()) / 2;
  const int count = bench.display().directions[0];
  double wrong = 0, own = 0;
  for (int k = -reach; k <= reach; ++k) {
    if (seen + k < 0 || seen + k >= count) continue;
    const double at = bench.eyePlaceFor(seen + k + 0.5, hogel, 0) - hogel;
    const bool isRight = hogel + at * head.z / bench.distance() > border;
    (isRight ? wrong : own) += weights[std::size_t(k + reach)];
  }
  if (bench.psf().border != PsfBorder::renormalise && (seen < reach || seen >= count - reach))
    return noValue;
  const double sum = wrong + own;
  return bench.psf().light == LightModel::linear
             ? wrong / own
             : light(whiteCode * wrong / sum) / light(whiteCode * own / sum);
}

void addCrosstalk(const Bench& bench, double ipd, std::vector<Measurement>& all) {
  constexpr int steps = 9;
  const Vec3 eye = bench.eye();
  for (int step = -steps; step <= steps; ++step) {
    const double x = 0.45 * ipd * step / steps;
    const Vec3 head{eye.x + x, eye.y, eye.z};
    Measurement one{"crosstalk", "", "x=" + metres(x), {}, noValue, x};
    one.simulate = [=](Bench& b) { return crosstalk(b, head, ipd, eye.x); };
    if (bench.pupil().diameter == 0) one.closedForm = crosstalkForm(bench, head, ipd, eye.x);
    // The designated eye position comes first.
    if (step == 0)
      all.insert(all.end() - steps, std::move(one));
    else
      all.push_back(std::move(one));
  }
}

/// Returns the way that the eye has to move until a hogel shows its next direction.
double stepByMoving(Bench& bench, std::size_t axis) {
  constexpr int directions = 12;
  constexpr int perDirection = 24;
  const double step = bench.distance() * bench.step(axis) / perDirection;
  const double hogel = bench.middleHogel(axis);
  const TestLight noise = [&bench, axis](const plugin::Ray& ray) {
    const double value = std::sin(12.9898 * std::floor(bench.directionOf(ray, axis))) * 43758.5453;
    return grey(whiteCode * (value - std::floor(value)));
  };
  const int last = bench.display().directions[axis] - 1;
  const double middle = bench.eyePlaceFor(0.5 * (last + 1) + 0.03, hogel, axis);
  std::vector<double> changes;
  double before = noValue;
  for (int k = 0; k < directions * perDirection; ++k) {
    const double place = middle + (k - directions * perDirection / 2) * step;
    const Vec2 point = axis == 0 ? Vec2{hogel, 0} : Vec2{0, hogel};
    const double value = bench.lookAt(noise, movedTo(bench.eye(), place, axis), point)[0];
    if (!std::isnan(before) && !std::isnan(value) && value != before) changes.push_back(place);
    before = value;
  }
  return changes.size() < 2 ? noValue
                            : (changes.back() - changes.front()) / double(changes.size() - 1);
}

}  // namespace

double halfZone(const Bench& bench, double distance, std::size_t axis) {
  const PanelParams& display = bench.display();
  const double slope = std::tan(display.fov[axis] * std::numbers::pi / 360);
  const double turn = display.viewingDistance == notGiven ? 0 : distance / display.viewingDistance;
  return distance * slope - display.size[axis] / 2 * std::abs(1 - turn);
}

double shareSeen(const Bench& bench, const Vec3& eye) {
  constexpr int count = 800;
  const Display panel(bench.display());
  const auto isSeen = [&](std::size_t axis, double share) {
    const double place = bench.display().size[axis] * (share - 0.5);
    const Vec3 point = axis == 0 ? Vec3{place, 0, 0} : Vec3{0, place, 0};
    const auto hit = panel.intersectPlane(eye, point - eye);
    if (!hit) return false;
    const double direction = axis == 0 ? hit->u : hit->v;
    return direction >= 0 && direction < bench.display().directions[axis];
  };
  double product = 1;
  for (const std::size_t axis : {0, 1}) {
    int seen = 0;
    for (int k = 0; k < count; ++k) seen += isSeen(axis, (k + 0.5) / count) ? 1 : 0;
    if (seen == count && !(isSeen(axis, 1e-9) && isSeen(axis, 1 - 1e-9))) --seen;
    product *= double(seen) / count;
  }
  return product;
}

double crosstalk(Bench& bench, const Vec3& head, double ipd, double border) {
  const MeterAperture aperture(bench);
  const Vec3 left{head.x - ipd / 2, head.y, head.z};
  const double hogel = bench.middleHogel(0);
  const TestLight channels = [&](const plugin::Ray& ray) {
    const bool isRight = pointOf(ray, head.z).x > border;
    return isRight ? CodeValues{whiteCode, 0, 0} : CodeValues{0, whiteCode, 0};
  };
  const auto [right, own, black] = bench.lookAt(channels, left, {hogel, 0});
  return (light(right) - light(black)) / (light(own) - light(black));
}

void addViewingSpace(const Bench& bench, double ipd, std::vector<Measurement>& all) {
  addZone(bench, all);
  if (bench.display().directions[0] > 1) {
    addQualified(bench, ipd, all);
    addCrosstalk(bench, ipd, all);
  }
  const std::size_t axis = mainAxis(bench);
  if (bench.display().directions[axis] < 2) return;
  all.push_back({"parallaxStep", "m", axisName(axis) + " z=" + metres(bench.distance()),
                 [axis](Bench& b) {
                   Bench plain = b.withoutBlur();
                   return stepByMoving(plain, axis);
                 },
                 bench.isLinear(axis) ? bench.distance() * bench.step(axis) : noValue});
}

}  // namespace hogelscope
