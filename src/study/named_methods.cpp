// SPDX-License-Identifier: BSD-3-Clause
// The compared methods.
#include <algorithm>
#include <limits>

#include "core/optics/distortion.h"
#include "study/tradeoff.h"

namespace hogelscope {

namespace {

constexpr auto nearest = Reconstruction::nearest;
constexpr auto bilinear = Reconstruction::bilinear;
constexpr auto quadrilinear = Reconstruction::quadrilinear;
constexpr auto exactly = LensMapping::exact;
constexpr double halfACodeValue = 0.5;
constexpr double everything = std::numeric_limits<double>::infinity();

NamedMethod lens(const std::string& name, LensInverse inverse, int steps) {
  return {name, nearest, 1, exactly, {.lens = inverse, .lensSteps = steps}};
}

NamedMethod rays(Reconstruction how, int samples) {
  const std::string name(nameOf(how));
  const std::string n = std::to_string(samples);
  return {samples == 1 ? name : name + " " + n + "×" + n, how, samples};
}

}  // namespace

std::vector<NamedMethod> methodsFor(const std::vector<RenderJob>& views) {
  std::vector<NamedMethod> methods = namedMethods();
  const bool hasLens = std::ranges::any_of(
      views, [](const RenderJob& job) { return !Distortion(job.state.distortion).isIdentity(); });
  if (!hasLens)
    std::erase_if(methods, [](const NamedMethod& m) {
      return m.mapping != exactly || m.method.lens != Method{}.lens;
    });
  return methods;
}

std::vector<NamedMethod> namedMethods() {
  return {
      {"exact"},
      {"exact, float", nearest, 1, exactly, {.isSingle = true}},
      {"direct", nearest, 1, LensMapping::direct},
      lens("fixed point 1", LensInverse::fixedPoint, 1),
      lens("fixed point 2", LensInverse::fixedPoint, 2),
      lens("fixed point 5", LensInverse::fixedPoint, 5),
      lens("fixed point 20", LensInverse::fixedPoint, 20),
      lens("Newton 5", LensInverse::newton, 5),
      lens("table 4 px", LensInverse::table, 4),
      lens("table 8 px", LensInverse::table, 8),
      lens("table 16 px", LensInverse::table, 16),
      {"PSF truncated", nearest, 1, exactly, {.droppedTaps = halfACodeValue}},
      {"PSF off", nearest, 1, exactly, {.droppedTaps = everything}},
      rays(bilinear, 1),
      rays(quadrilinear, 1),
      rays(nearest, 2),
      rays(nearest, 4),
      rays(nearest, 8),
      rays(bilinear, 2),
      rays(quadrilinear, 2),
      rays(quadrilinear, 4),
      rays(quadrilinear, 8),
      {"half size", nearest, 1, exactly, {.scale = 2}},
      {"quarter size", nearest, 1, exactly, {.scale = 4}},
      {"half size, bilinear", bilinear, 1, exactly, {.scale = 2}},
      {"half size, PSF off", nearest, 1, exactly, {.droppedTaps = everything, .scale = 2}},
      {"quarter size, PSF off", nearest, 1, exactly, {.droppedTaps = everything, .scale = 4}},
      {"table 8 px, PSF off, float",
       nearest,
       1,
       exactly,
       {LensInverse::table, 8, true, everything, 1}},
  };
}

}  // namespace hogelscope
