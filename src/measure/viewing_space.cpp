// SPDX-License-Identifier: BSD-3-Clause
// From where a display can be seen: viewing zone, qualified viewing space, crosstalk, parallax.
// Lens sheets share its map of the zone and its places of the head.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/bisect.h"
#include "measure/measurement.h"

namespace hogelscope {

namespace {

/// Where an eye sees the field of the hogels along an axis (docs/formulas.md, Measures of a unit):
/// |shift + scale eye/D − factor x| ≤ slope for a lens whose middle is seen at x.
struct FieldSeen {
  double slope;     ///< at the edge of a linear lens' field
  double shift;     ///< by the offset of a unit's lens array
  double scale;     ///< of slopes
  double perMetre;  ///< by the viewing distance and the pitch of a unit's lenses
  double defocus;   ///< what the edges of a lens add, a slope
  double panel;     ///< the panel's side, metres
  double pitch;

  [[nodiscard]] double factor(double distance) const { return scale / distance + perMetre; }
  /// Returns the slope that all of the panel takes, as an eye on its axis sees it.
  [[nodiscard]] double whole(double distance) const {
    const double each = factor(distance);
    return std::abs(shift) + std::abs(each) * (panel - pitch) / 2 +
           std::abs(defocus - each * pitch / 2);
  }
};

FieldSeen fieldSeen(const Bench& bench, std::size_t axis) {
  const PanelParams& display = bench.display();
  const UnitLaw& law = bench.law();
  const double slope = std::tan(display.fov[axis] * std::numbers::pi / 360);
  const double perShift = 2 * slope / bench.pitch(axis);  // 1/gap
  const double pitchError = law.pitchError[axis] / (1 + law.pitchError[axis]);
  const double scale = law.scale[greenChannel];
  const double turn = display.viewingDistance == notGiven ? 0 : 1 / display.viewingDistance;
  return {slope,
          -perShift * law.offset[axis] * (1 - pitchError),
          scale,
          perShift * pitchError - scale * turn,
          slope * law.defocus,
          display.size[axis],
          bench.pitch(axis)};
}

/// Returns the distance from the panel at which all of it is seen from its axis.
double nearestZone(const Bench& bench, std::size_t axis) {
  const FieldSeen field = fieldSeen(bench, axis);
  // whole(D) = slope, where the inner edges of the outermost lenses are the last ones, or the
  // outer.
  const double left = field.slope - std::abs(field.shift);
  const double inner = (left - field.defocus) / (field.panel / 2 - field.pitch);
  const double outer = (left + field.defocus) / (field.panel / 2);
  const double factor = field.defocus >= inner * field.pitch / 2 ? inner : outer;
  return field.scale / (factor - field.perMetre);
}

/// Returns the share of the panel's side that an eye at `place` and `distance` sees.
double shareForm(const Bench& bench, double place, double distance, std::size_t axis) {
  const FieldSeen field = fieldSeen(bench, axis);
  const double half = bench.display().size[axis] / 2;
  const double factor = field.factor(distance);
  const double own = field.shift + field.scale * place / distance;
  if (std::abs(factor) < 1e-12) return std::abs(own) <= field.slope ? 1 : 0;
  const double middle = own / factor;
  const double reach = field.slope / std::abs(factor);
  const double seen = std::min(half, middle + reach) - std::max(-half, middle - reach);
  return std::max(seen, 0.0) / (2 * half);
}

/// Returns the share of the panel that sends light to an eye, counted over 800 rays along each
/// axis; 1 only if its edges do, too.
double shareSeen(const Bench& bench, const Vec3& eye) {
  constexpr int count = 800;
  const Display& panel = bench.panel();
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
  const bool hasForm = bench.display().lens == HogelLensModel::rectilinear;
  // None along an axis if the eye on it does not see all of the panel along the other one.
  for (const std::size_t axis : {0, 1})
    all.push_back({"viewingZone", "m", "whole panel " + axisName(axis) + " z=" + metres(distance),
                   [axis](Bench& b) {
                     const auto isIn = [&](double place) {
                       return shareSeen(b, movedTo({0, 0, b.distance()}, place, axis)) == 1;
                     };
                     if (!isIn(0)) return 0.0;
                     const double step = b.distance() / 20;
                     return endOf(0, step, 1000 * b.distance(), isIn) -
                            endOf(0, -step, 1000 * b.distance(), isIn);
                   },
                   !hasForm                                  ? noValue
                   : halfZone(bench, distance, 1 - axis) > 0 ? 2 * halfZone(bench, distance, axis)
                                                             : 0});
  all.push_back({"viewingZone", "m", "whole panel from z",
                 [](Bench& b) {
                   const auto isIn = [&](double z) { return shareSeen(b, {0, 0, z}) == 1; };
                   double z = 1e-3 * b.distance();
                   while (!isIn(z) && z < 1e3 * b.distance()) z *= 1.5;
                   return isIn(z) ? endOf(z, -z / 60, z, isIn) : noValue;
                 },
                 hasForm ? std::max(nearestZone(bench, 0), nearestZone(bench, 1)) : noValue});
  addZoneMap(bench,
             {shareSeen,
              [&](const Vec3& eye) {
                return hasForm ? shareForm(bench, eye.x, eye.z, 0) * shareForm(bench, 0, eye.z, 1)
                               : noValue;
              }},
             all);
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
      sum += linearFromEncoded(point.values[0]);
  }
  return sum / (side * side);
}

/// Returns the crosstalk between the two eyes of a head at `head`, (L_KW − L_KK)/(L_WK − L_KK) of
/// the left eye in linear light, in a spot in the panel's middle, if the light that leaves to the
/// right of `border` is the right eye's.
double crosstalk(Bench& bench, const Vec3& head, double ipd, double border) {
  const MeterAperture aperture(bench);
  const Vec3 left{head.x - ipd / 2, head.y, head.z};
  const double hogel = bench.middleHogel(0);
  const TestLight channels = [&](const plugin::Ray& ray) {
    const bool isRight = pointOf(ray, head.z).x > border;
    return isRight ? CodeValues{whiteCode, 0, 0} : CodeValues{0, whiteCode, 0};
  };
  const auto [right, own, black] = bench.lookAt(channels, left, {hogel, 0});
  return (linearFromEncoded(right) - linearFromEncoded(black)) /
         (linearFromEncoded(own) - linearFromEncoded(black));
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
      return isQualified(b, movedTo(b.eye(), place, axis), ipd, luminance);
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
  return bench.psf().light == LightModel::linear ? wrong / own
                                                 : linearFromEncoded(whiteCode * wrong / sum) /
                                                       linearFromEncoded(whiteCode * own / sum);
}

/// Returns the way that the eye has to move until a hogel shows its next direction.
double stepByMoving(Bench& bench, std::size_t axis) {
  constexpr int directions = 12;
  constexpr int perDirection = 24;
  const double step =
      bench.distance() * bench.step(axis) / bench.law().scale[greenChannel] / perDirection;
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
    const double value =
        bench.lookAt(noise, movedTo(bench.eye(), place, axis), onAxis(hogel, axis))[greenChannel];
    if (!std::isnan(before) && !std::isnan(value) && value != before) changes.push_back(place);
    before = value;
  }
  return changes.size() < 2 ? noValue
                            : (changes.back() - changes.front()) / double(changes.size() - 1);
}

}  // namespace

double halfZone(const Bench& bench, double distance, std::size_t axis) {
  const FieldSeen field = fieldSeen(bench, axis);
  const double left = field.slope - field.whole(distance);
  // To both sides of the axis together, however far the offset moves the zone.
  return left < 0 ? 0 : distance / field.scale * (left + std::abs(field.shift));
}

void addZoneMap(const Bench& bench, const EyeFigure& share, std::vector<Measurement>& all) {
  constexpr int columns = 41;
  constexpr int rows = 25;
  const double distance = bench.distance();
  const double reach = 1.2 * std::max(distance, bench.display().size[0]);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double z = 2 * distance * (row + 0.5) / rows;
      const double x = reach * (2 * (column + 0.5) / columns - 1);
      const Vec3 eye{x, 0, z};
      all.push_back({"viewingZone", "", "share x=" + metres(x) + " z=" + metres(z),
                     [eye, simulate = share.simulate](Bench& b) { return simulate(b, eye); },
                     share.closedForm(eye), x, z});
    }
}

void addCrosstalk(const Bench& bench, double ipd, const EyeFigure& crosstalk,
                  std::vector<Measurement>& all) {
  constexpr int steps = 9;
  const auto add = [&](int step) {
    const double x = 0.45 * ipd * step / steps;
    const Vec3 head{bench.eye().x + x, bench.eye().y, bench.eye().z};
    all.push_back({"crosstalk", "", "x=" + metres(x),
                   [head, simulate = crosstalk.simulate](Bench& b) { return simulate(b, head); },
                   crosstalk.closedForm(head), x});
  };
  add(0);
  for (int step = -steps; step <= steps; ++step)
    if (step != 0) add(step);
}

void addViewingSpace(const Bench& bench, double ipd, std::vector<Measurement>& all) {
  addZone(bench, all);
  if (bench.display().directions[0] > 1) {
    addQualified(bench, ipd, all);
    const double border = bench.eye().x;
    const bool hasForm = bench.pupil().diameter == 0;
    addCrosstalk(bench, ipd,
                 {[=](Bench& b, const Vec3& head) { return crosstalk(b, head, ipd, border); },
                  [&](const Vec3& head) {
                    return hasForm ? crosstalkForm(bench, head, ipd, border) : noValue;
                  }},
                 all);
  }
  const std::size_t axis = mainAxis(bench);
  if (bench.display().directions[axis] < 2) return;
  all.push_back({"parallaxStep", "m", axisName(axis) + " z=" + metres(bench.distance()),
                 [axis](Bench& b) {
                   Bench plain = b.withoutBlur();
                   return stepByMoving(plain, axis);
                 },
                 bench.isLinear(axis)
                     ? bench.distance() * bench.step(axis) / bench.law().scale[greenChannel]
                     : noValue});
}

}  // namespace hogelscope
