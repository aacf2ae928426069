// SPDX-License-Identifier: BSD-3-Clause
// What a view needs to have modelled, and what not.
#include "core/engine/plan.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace hogelscope {

namespace {

/// The sum of the window's weights where the middle one is 1.
double weightWithin(const PsfParams& psf, int reach) {
  double sum = 0;
  for (int x = -reach; x <= reach; ++x) {
    const double s = x / psf.sigma;
    sum += std::exp(-s * s / 2);
  }
  return sum * sum;
}

int neededReach(const PsfParams& psf, double dropped) {
  int reach = (psf.windowSize - 1) / 2;
  while (reach > 0 && leakageLoss(psf, reach - 1) < dropped) --reach;
  return reach;
}

std::string raysOf(const View& view) {
  const auto [width, height] = view.state.camera.res;
  const int n = view.sampling.samplesPerPixel;
  return std::to_string(std::int64_t(width) * height * n * n) + " rays";
}

std::string lensWords(const View& view) {
  if (view.sampling.mapping == LensMapping::direct) return "applied directly";
  const std::string steps = std::to_string(view.method.lensSteps);
  switch (view.method.lens) {
    case LensInverse::newton:
      return "inverted by " + steps + " Newton steps";
    case LensInverse::fixedPoint:
      return "inverted by " + steps + " fixed-point iterations";
    case LensInverse::table:
      return "inverted exactly every " + steps + " pixels, bilinear between";
    default:
      return "inverted exactly";
  }
}

void decideLens(const View& view, Plan& plan) {
  const std::string table =
      bytesText(LensTable::bytes(lensKeyOf(view.state, view.sampling, view.method)));
  plan.hasLens = !Distortion(view.state.distortion).isIdentity();
  if (!plan.hasLens) {
    plan.decisions.push_back({"no lens model", "all coefficients are 0", "a table of " + table});
    return;
  }
  const std::string what = "the lens, " + lensWords(view);
  plan.isTableKept = LensTable::bytes(lensKeyOf(view.state, view.sampling, view.method)) <=
                     LensTables::largestBytes;
  if (plan.isTableKept)
    plan.decisions.push_back(
        {what, "one table of rays for all states with this lens and resolution, " + table,
         raysOf(view) + " through the lens for each further picture"});
  else
    plan.decisions.push_back({what,
                              "its table of rays would be larger than " +
                                  bytesText(LensTables::largestBytes) +
                                  ", so they are made row by row for each picture",
                              table});
}

void decidePsf(const View& view, Plan& plan) {
  const PsfParams& psf = view.state.psf;
  const double dropped = view.method.droppedTaps;
  const int windowReach = (psf.windowSize - 1) / 2;
  plan.psfReach = windowReach > 0 ? neededReach(psf, dropped) : 0;
  const auto square = [](int reach) { return (2 * reach + 1) * (2 * reach + 1); };
  const auto taps = [square](int reach) { return std::to_string(square(reach)); };
  if (windowReach == 0) {
    plan.decisions.push_back({"no light leakage", "windowSize is 1", ""});
    return;
  }
  if (plan.psfReach == windowReach) {
    plan.decisions.push_back(
        {"light leakage of " + taps(windowReach) + " taps", "each of them counts", ""});
    return;
  }
  const std::string what = plan.psfReach == 0 ? "no light leakage"
                                              : "light leakage of " + taps(plan.psfReach) +
                                                    " taps, not " + taps(windowReach);
  const std::string why = dropped > 0.5 ? "the method leaves the others out"
                                        : "the others change no pixel's light by " +
                                              numberText(dropped) + " code values";
  plan.decisions.push_back(
      {what, why,
       std::to_string(square(windowReach) - square(plan.psfReach)) + " taps for each ray"});
}

void decideLight(const View& view, Plan& plan) {
  const SamplingParams& sampling = view.sampling;
  const bool isSum = plan.psfReach > 0 || sampling.samplesPerPixel > 1 ||
                     sampling.reconstruction != Reconstruction::nearest;
  plan.sumsLinear = isSum && view.state.psf.light == LightModel::linear;
  const bool isByte = view.lightField->type() == StoredType::uint8;
  plan.copiesTexels = !isSum && isByte && view.lightField->slice() == nullptr;
  if (plan.copiesTexels)
    plan.decisions.push_back(
        {"texels are copied", "nothing is summed and they have 8 bits", "all arithmetic on light"});
  if (!isSum && view.state.psf.light == LightModel::linear)
    plan.decisions.push_back(
        {"no decoding to linear light", "nothing is summed", "two conversions for each ray"});
}

void decideOutline(const View& view, Plan& plan) {
  const Vec3 eye = Display(view.display).displayFromWorld().point(view.state.camera.eye);
  if (!(eye.z > 0))
    plan.decisions.push_back(
        {"no rays at all", "the eye is not in front of the panel", raysOf(view)});
  plan.knowsOutline = !plan.hasLens && view.sampling.samplesPerPixel == 1 &&
                      view.display.lens == HogelLens::rectilinear && eye.z > 0;
  if (plan.knowsOutline)
    plan.decisions.push_back({"only rays within the panel's outline and angular field",
                              "the part of each row that sees it is known beforehand",
                              "the rays that miss it"});
}

}  // namespace

LensKey lensKeyOf(const CameraState& state, const SamplingParams& sampling, const Method& method) {
  const Camera camera(state.camera, state.intrinsics);
  return {state.distortion, sampling.mapping,         state.camera.res, camera.focalLength(),
          camera.centre(),  sampling.samplesPerPixel, method.lens,      method.lensSteps};
}

/// The middle tap lies always inside the hogel, so the weights that are left add up to 1 or more,
/// and leaving out taps of weight d changes their mean by at most 2·d of its range: 2·255·d code
/// values, times 12.92 where linear light is summed, since encoding is that steep at black.
double leakageLoss(const PsfParams& psf, int reach) {
  const double steepest = psf.light == LightModel::linear ? 12.92 : 1;
  return 2 * 255 * steepest *
         (weightWithin(psf, (psf.windowSize - 1) / 2) - weightWithin(psf, reach));
}

Plan plan(const View& view) {
  Plan result;
  if (view.method.isSingle)
    result.decisions.push_back({"rays in single precision", "the method says so", ""});
  decideLens(view, result);
  decideOutline(view, result);
  decidePsf(view, result);
  decideLight(view, result);
  return result;
}

std::string oneLine(const View& view, const Plan& plan) {
  const int n = view.sampling.samplesPerPixel;
  const auto square = [](int width) { return std::to_string(width * width); };
  std::string line(nameOf(view.sampling.reconstruction));
  line += ", " + square(n) + (n == 1 ? " ray" : " rays") + " a pixel, ";
  if (view.state.psf.windowSize == 1)
    line += "no leakage, ";
  else
    line += square(2 * plan.psfReach + 1) + " of " + square(view.state.psf.windowSize) + " taps, ";
  if (!plan.hasLens) return line + "no lens";
  return line + (plan.isTableKept ? "lens table kept" : "lens row by row");
}

}  // namespace hogelscope
