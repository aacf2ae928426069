// SPDX-License-Identifier: BSD-3-Clause
// The detail that a display shows at each depth, by the contrast of gratings on planes: resolution,
// depth of field, depths that are sharp, contrast over depth and over the focus of a pupil.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/bisect.h"
#include "core/panel/depth_budget.h"
#include "measure/contrast.h"
#include "measure/measurement.h"

namespace hogelscope {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
const double half = 2 / std::numbers::pi;  ///< sinc(1/2)

std::string placeOf(const Grating& grating) {
  return "f=" + numberText(fourDigits(grating.frequency / 1000)) + "/mm z=" + metres(grating.z);
}

/// Returns p/s, or a depth of the eye's order if the axis has but one direction.
double depthScale(const Bench& bench, std::size_t axis) {
  return bench.display().directions[axis] > 1 ? bench.pitch(axis) / bench.step(axis)
                                              : bench.distance();
}

/// Whether directions alone limit depths, so that ±p/s are exact.
bool hasEvenSteps(const Bench& bench) {
  return hasDirections(bench.display()) && bench.display().viewingDistance == notGiven;
}

double nyquist(const Bench& bench, std::size_t axis) {
  return 1 / (2 * bench.pitch(axis));
}

void addMtf(const Bench& bench, std::size_t axis, std::vector<Measurement>& all) {
  constexpr int frequencies = 24;
  constexpr int depths = 41;
  const double distance = bench.distance();
  // In cycles per degree of the eye, to twice what hogels can show on the panel, and in dioptres.
  const double perDegree = distance * std::numbers::pi / 180;
  const double most = 2 * nyquist(bench, axis) * perDegree;
  const double scale = depthScale(bench, axis);
  const double end = std::min(2.0 * scale / (distance * distance), 0.97 / distance);
  for (int k = 0; k < depths; ++k) {
    const double dioptres = end * (2.0 * k / (depths - 1) - 1);
    const double z = depthAt(dioptres, distance);
    for (int n = 1; n <= frequencies; ++n) {
      const double cycles = most * n / frequencies;
      const Grating grating{cycles / ((distance - z) * std::numbers::pi / 180), z};
      all.push_back({"mtf", "", placeOf(grating),
                     [grating, axis](Bench& b) { return contrast(b, grating, axis); },
                     bench.isLinear(axis) ? contrastLaw(bench, grating, axis) : noValue, dioptres,
                     cycles});
    }
  }
}

/// The finest grating on a plane, up to the hogels' limit, of whose contrast a half is left.
void addResolution(const Bench& bench, std::size_t axis, const std::string& where, double z,
                   std::vector<Measurement>& all) {
  const double limit = nyquist(bench, axis);
  const auto finest = [limit](const auto& contrastOf) {
    const auto isResolved = [&](double frequency) { return contrastOf(frequency) >= 0.5; };
    return 1e-3 * (isResolved(limit) ? limit : bisect({0, limit}, 30, isResolved).inside);
  };
  all.push_back({"spatialResolution", "1/mm", where,
                 [=](Bench& b) {
                   return finest([&](double f) { return contrast(b, {f, z}, axis); });
                 },
                 bench.isLinear(axis) ? finest([&](double f) {
                   return contrastLaw(bench, {f, z}, axis);
                 })
                                      : noValue,
                 z});
}

void addSpatialResolution(const Bench& bench, std::size_t axis, std::vector<Measurement>& all) {
  const double scale = depthScale(bench, axis);
  for (const double z : {0.0, -0.5 * scale, -scale, 0.5 * scale})
    if (z < 0.9 * bench.distance())
      addResolution(bench, axis, "contrast 0.5 z=" + metres(z), z, all);
  // Along the lenses, where all views have the same height.
  if (!hasDirections(bench.display()))
    addResolution(bench, 1, "up the panel, contrast 0.5 z=0 m", 0, all);
}

/// The depths behind the panel at which the contrast of the hogels' finest grating falls to a part
/// of what it is on the panel.
void addDepthOfField(const Bench& bench, std::size_t axis, std::vector<Measurement>& all) {
  const double frequency = nyquist(bench, axis);
  const double scale = depthScale(bench, axis);
  const std::string where = "behind f=" + numberText(fourDigits(frequency / 1000)) + "/mm";
  const auto add = [&](const std::string& name, double level, bool hasBlur) {
    const auto depthOf = [=](const auto& contrastOf) {
      const double onPanel = contrastOf(Grating{frequency, 0});
      return depthOfFall(
          [&](double z) {
            return contrastOf(Grating{frequency, -z}) / onPanel;
          },
          level, scale);
    };
    const auto formOf = [&] {
      const Bench own = hasBlur ? bench : bench.withoutBlur();
      return depthOf([&](const Grating& grating) { return contrastLaw(own, grating, axis); });
    };
    all.push_back({name, "m", where,
                   [=](Bench& b) {
                     Bench own = hasBlur ? b : b.withoutBlur();
                     return depthOf(
                         [&](const Grating& grating) { return contrast(own, grating, axis); });
                   },
                   !bench.isLinear(axis)                                        ? noValue
                   : !hasBlur && hasEvenSteps(bench) && bench.twin() == nullptr ? scale
                                                                                : formOf()});
  };
  add("depthOfField", half, false);
  add("depthOfField50", 0.5, true);
  add("depthOfField10", 0.1, true);
}

/// The depths at which one direction is as wide as a hogel, as the eye sees both: of gratings that
/// have, as this eye sees them, the hogels' limit on the panel, the share of the contrast that the
/// directions leave falls to sinc(1/2).
void addDepthLimits(const Bench& bench, std::size_t axis, std::vector<Measurement>& all) {
  const double distance = bench.distance();
  const double frequency = nyquist(bench, axis);
  const double display = depthScale(bench, axis) / (distance * distance);  // p/(s D²), dioptres
  const bool isParallel = hasEvenSteps(bench);
  for (const double sign : {1.0, -1.0}) {
    const bool isFront = sign > 0;
    // Searches with the contrast of gratings.
    const auto search = [=](const auto& contrastOf) {
      const auto fall = [&](double dioptres) {
        const double z = std::max(depthAt(sign * dioptres, distance), -1e4 * distance);
        const double f = frequency * distance / (distance - z);
        return contrastOf(Grating{f, z}) / contrastOf(Grating{f, 0});
      };
      // Behind the panel there is nothing beyond −1/D.
      if (!isFront && fall(1 / distance) > half) return infinite;
      return sign * depthAt(sign * depthOfFall(fall, half, display), distance);
    };
    const auto formOf = [&] {
      if (bench.sheet() != nullptr)
        return isFront ? bench.numbersOfSheet().depthFront : bench.numbersOfSheet().depthBehind;
      if (!bench.isLinear(axis)) return noValue;
      if (isParallel) return sign * depthAt(sign * display, distance);
      const Bench plain = bench.withoutBlur();
      return search([&](const Grating& grating) { return contrastLaw(plain, grating, axis); });
    };
    all.push_back({isFront ? "depthFront" : "depthBehind", "m", "z=" + metres(distance),
                   [=](Bench& b) {
                     Bench plain = b.withoutBlur();
                     return search(
                         [&](const Grating& grating) { return contrast(plain, grating, axis); });
                   },
                   formOf()});
  }
}

void addThroughFocus(const Bench& bench, std::size_t axis, double pupil,
                     std::vector<Measurement>& all) {
  constexpr int steps = 20;
  const double distance = bench.distance();
  const double frequency = nyquist(bench, axis) / 2;
  const double z = -0.25 * depthScale(bench, axis);
  const Grating grating{frequency * distance / (distance - z), z};
  const double range = 1.5;  // dioptres to each side of the content
  const double middle = 1 / (distance - z);
  for (int k = -steps; k <= steps; ++k) {
    const double vergence = middle + range * k / steps;
    if (vergence <= 0.05) continue;
    PupilParams params = bench.pupil();
    if (params.diameter == 0) params.diameter = pupil;
    params.focus = 1 / vergence;
    if (params.samples == 0) params.samples = 64;  // the law is of a whole pupil
    Bench focused = bench;
    focused.setPupil(params);
    all.push_back({"throughFocus", "", "focus=" + metres(params.focus) + " " + placeOf(grating),
                   [=](Bench& b) {
                     Bench own = b;
                     own.setPupil(params);
                     return contrast(own, grating, axis);
                   },
                   bench.isLinear(axis) ? contrastLaw(focused, grating, axis) : noValue, vergence});
  }
}

/// The contrast that diffraction at a square lenslet leaves, 1 − λ f |z|/p: not simulated.
void addDiffraction(const Bench& bench, std::size_t axis, std::vector<Measurement>& all) {
  constexpr double wavelength = 550e-9;
  const double pitch = bench.pitch(axis);
  const Grating grating{nyquist(bench, axis), -depthScale(bench, axis)};
  const double left = 1 - wavelength * grating.frequency * std::abs(grating.z) / pitch;
  all.push_back({"diffraction", "", placeOf(grating) + " 550 nm", {}, std::max(left, 0.0)});
}

}  // namespace

void addGratings(const Bench& bench, double pupil, std::vector<Measurement>& all) {
  const std::size_t axis = mainAxis(bench);
  addSpatialResolution(bench, axis, all);
  addMtf(bench, axis, all);
  if (bench.display().directions[axis] > 1) {
    addDepthOfField(bench, axis, all);
    addDepthLimits(bench, axis, all);
  }
  addThroughFocus(bench, axis, pupil, all);
  if (hasDirections(bench.display())) addDiffraction(bench, axis, all);
}

}  // namespace hogelscope
