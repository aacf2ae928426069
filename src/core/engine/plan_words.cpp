// SPDX-License-Identifier: BSD-3-Clause
// A plan in words.
#include "core/engine/plan_words.h"

#include "core/base/text.h"

namespace hogelscope {

namespace {

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

Decision lensDecision(const View& view, const Plan& plan) {
  const std::string table =
      bytesText(LensTable::bytes(view.state.camera.res, view.sampling.samplesPerPixel));
  if (!plan.hasLens) return {"no lens model", "all coefficients are 0", "a table of " + table};
  const std::string what = "the lens, " + lensWords(view);
  if (plan.isTableKept)
    return {what, "one table of rays for all states with this lens and resolution, " + table,
            raysOf(view) + " through the lens for each further picture"};
  return {what,
          "its table of rays would be larger than " + bytesText(LensTables::largestBytes) +
              ", so they are made row by row for each picture",
          table};
}

Decision leakageDecision(const View& view, const Plan& plan) {
  const auto square = [](int reach) { return (2 * reach + 1) * (2 * reach + 1); };
  const auto taps = [square](int reach) { return std::to_string(square(reach)); };
  const int windowReach = (view.state.psf.windowSize - 1) / 2;
  const double dropped = view.method.droppedTaps;
  if (windowReach == 0) return {"no light leakage", "windowSize is 1", ""};
  if (plan.psfReach == windowReach)
    return {"light leakage of " + taps(windowReach) + " taps", "each of them counts", ""};
  return {plan.psfReach == 0
              ? "no light leakage"
              : "light leakage of " + taps(plan.psfReach) + " taps, not " + taps(windowReach),
          dropped > 0.5
              ? "the method leaves the others out"
              : "the others change no pixel's light by " + numberText(dropped) + " code values",
          std::to_string(square(windowReach) - square(plan.psfReach)) + " taps for each ray"};
}

}  // namespace

std::vector<Decision> decisionsOf(const View& view, const Plan& plan) {
  std::vector<Decision> decisions;
  if (view.method.isSingle)
    decisions.push_back({"rays in single precision", "the method says so", ""});
  decisions.push_back(lensDecision(view, plan));
  if (plan.isBehind)
    decisions.push_back({"no rays at all", "the eye is not in front of the panel", raysOf(view)});
  if (plan.knowsOutline)
    decisions.push_back({"only rays within the panel's outline and angular field",
                         "the part of each row that sees it is known beforehand",
                         "the rays that miss it"});
  decisions.push_back(leakageDecision(view, plan));
  if (plan.copiesTexels)
    decisions.push_back(
        {"texels are copied", "nothing is summed and they have 8 bits", "all arithmetic on light"});
  if (!plan.sumsTexels && view.state.psf.light == LightModel::linear)
    decisions.push_back(
        {"no decoding to linear light", "nothing is summed", "two conversions for each ray"});
  return decisions;
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
