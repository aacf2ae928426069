// SPDX-License-Identifier: BSD-3-Clause
// What a data sheet of a display of hogels says: pitch and directions, counted along rays; pixels.
#include <cmath>
#include <numbers>

#include "core/base/bisect.h"
#include "measure/measurement.h"

namespace hogelscope {

namespace {

constexpr int halvings = 60;

/// Returns the width of the hogel in the panel's middle, along an axis.
double pitchByRays(const Bench& bench, std::size_t axis) {
  const Display& panel = bench.panel();
  const auto hogelAt = [&](double place) {
    const Vec3 eye = axis == 0 ? Vec3{place, 0, 1} : Vec3{0, place, 1};
    const auto hit = panel.intersectPlane(eye, {0, 0, -1});
    return std::floor(axis == 0 ? hit->i : hit->j);
  };
  const double middle = bench.middleHogel(axis);
  const double hogel = hogelAt(middle);
  const auto isSame = [&](double place) { return hogelAt(place) == hogel; };
  const double far = bench.display().size[axis];
  return bisect({middle, middle + far}, halvings, isSame).middle() -
         bisect({middle, middle - far}, halvings, isSame).middle();
}

/// Returns the slopes at the edges of the direction in the middle of the field, along an axis.
std::array<double, 2> slopesByRays(const Bench& bench, std::size_t axis) {
  const Display& panel = bench.panel();
  const auto directionAt = [&](double slope) {
    const Vec3 direction = axis == 0 ? Vec3{-slope, 0, -1} : Vec3{0, slope, -1};
    const Vec3 eye = -1.0 * direction;  // looks at the panel's centre
    const auto hit = panel.intersectPlane(eye, direction);
    return axis == 0 ? hit->u : hit->v;
  };
  const double middle = std::floor(directionAt(0));
  const auto isBelow = [&](double slope) { return directionAt(slope) < middle + 0.5; };
  const double inside = bisect({-100, 100}, halvings, isBelow).middle();
  const auto isSame = [&](double slope) { return std::floor(directionAt(slope)) == middle; };
  return {bisect({inside, -100}, halvings, isSame).middle(),
          bisect({inside, 100}, halvings, isSame).middle()};
}

}  // namespace

void addDataSheet(const Bench& bench, double pupil, std::vector<Measurement>& all) {
  const PanelParams& display = bench.display();
  for (const std::size_t axis : {0, 1}) {
    const UnitLaw& law = bench.law();
    const double distance = bench.distance();
    // Of the green channel of a unit, whose gap makes directions narrower.
    const double step = bench.step(axis) / law.scale[greenChannel];
    const double slope =
        std::tan(display.fov[axis] * std::numbers::pi / 360) / law.scale[greenChannel];
    const bool hasForm = display.lens == HogelLensModel::rectilinear;
    all.push_back(
        {"hogelPitch", "m", axisName(axis), [axis](Bench& b) { return pitchByRays(b, axis); },
         display.size[axis] / display.hogels[axis] * (1 + law.pitchError[axis]) / law.turn});
    all.push_back({"slopeStep", "", axisName(axis),
                   [axis](Bench& b) {
                     const auto [low, high] = slopesByRays(b, axis);
                     return high - low;
                   },
                   hasForm ? 2 * slope / display.directions[axis] : noValue});
    // An odd number has its middle direction on the axis; of an even one, two meet there.
    const bool isOdd = display.directions[axis] % 2 == 1;
    all.push_back({"degreesPerDirection", "°", axisName(axis),
                   [axis](Bench& b) {
                     const auto [low, high] = slopesByRays(b, axis);
                     return degrees(std::atan(high) - std::atan(low));
                   },
                   !hasForm ? noValue
                   : isOdd  ? degrees(2 * std::atan(step / 2))
                            : degrees(std::atan(step))});
    all.push_back({"directionsPerPupil", "", axisName(axis),
                   [axis, pupil](Bench& b) {
                     const auto [low, high] = slopesByRays(b, axis);
                     return pupil / (b.distance() * (high - low));
                   },
                   hasForm ? pupil * display.directions[axis] / (distance * 2 * slope) : noValue});
  }
  const auto [nx, ny] = display.hogels;
  const auto [du, dv] = display.directions;
  const double pixels = double(nx) * ny * du * dv / 1e6;
  all.push_back({"megapixels", "Mpx", "all hogels", [pixels](Bench&) { return pixels; }, pixels});
}

}  // namespace hogelscope
