// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/plan_words.h"

#include <cmath>

#include "core/base/text.h"

namespace hogelscope {

namespace {

std::string raysOf(const RenderJob& job) {
  const auto [width, height] = job.state.camera.res;
  const int n = job.sampling.samplesPerPixel;
  return std::to_string(std::int64_t(width) * height * n * n) + " rays";
}

std::string lensWords(const RenderJob& job) {
  if (job.sampling.mapping == LensMapping::direct) return "applied directly";
  const std::string steps = std::to_string(job.method.lensSteps);
  switch (job.method.lens) {
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

Decision lensDecision(const RenderJob& job, const Plan& plan) {
  const std::string table =
      bytesText(LensTable::bytes(job.state.camera.res, job.sampling.samplesPerPixel));
  if (!plan.hasLens) return {"no lens model", "all coefficients are 0", "a table of " + table};
  const std::string what = "the lens, " + lensWords(job);
  if (plan.isTableKept)
    return {what, "one table of rays for all states with this lens and resolution, " + table,
            raysOf(job) + " through the lens for each further picture"};
  return {what,
          "its table of rays would be larger than " + bytesText(LensTables::largestBytes) +
              ", so they are made row by row for each picture",
          table};
}

Decision leakageDecision(const RenderJob& job, const Plan& plan) {
  const auto square = [](int reach) { return (2 * reach + 1) * (2 * reach + 1); };
  const auto taps = [square](int reach) { return std::to_string(square(reach)); };
  const int windowReach = (job.state.psf.windowSize - 1) / 2;
  const double dropped = job.method.droppedTaps;
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

/// Returns how a pupil's light spreads: "3.56 directions of a hogel enter it and 0.8 hogels blur".
std::string spreadWords(const Aperture& aperture) {
  return numberText(std::round(100 * aperture.directions) / 100) +
         " directions of a hogel enter it, and a point is blurred over " +
         numberText(std::round(100 * aperture.hogels) / 100) + " hogels";
}

Decision pupilDecision(const PupilParams& pupil, const Aperture& aperture) {
  const std::string focus =
      ", focused at " + numberText(std::round(1e4 * aperture.focus) / 1e4) + " m";
  if (aperture.isPinhole)
    return {"a pinhole", "the pupil changes nothing: " + spreadWords(aperture),
            "the samples of the pupil"};
  std::string why = "the state says so; the display needs " + std::to_string(aperture.wanted);
  if (pupil.samples == 0)
    why = aperture.wanted > Aperture::mostSamples
              ? "the most that are taken; the display needs " + std::to_string(aperture.wanted)
              : "as many as the display needs";
  return {std::to_string(aperture.points.size()) + " samples of the pupil" + focus,
          why + ": " + spreadWords(aperture), ""};
}

}  // namespace

std::vector<Decision> decisionsOf(const RenderJob& job, const Plan& plan) {
  std::vector<Decision> decisions;
  if (job.method.isSingle)
    decisions.push_back({"rays in single precision", "the method says so", ""});
  decisions.push_back(lensDecision(job, plan));
  if (job.state.pupil.diameter > 0)
    decisions.push_back(pupilDecision(job.state.pupil, plan.aperture));
  if (plan.isBehind)
    decisions.push_back({"no rays at all", "the eye is not in front of the panel", raysOf(job)});
  if (plan.knowsOutline)
    decisions.push_back({"only rays within the panel's outline and angular field",
                         "the part of each row that sees it is known beforehand",
                         "the rays that miss it"});
  decisions.push_back(leakageDecision(job, plan));
  if (plan.copiesTexels)
    decisions.push_back(
        {"texels are copied", "nothing is summed and they have 8 bits", "all arithmetic on light"});
  if (plan.usesStrips)
    decisions.push_back({"cells from polynomials of strips of 64 pixels",
                         "their errors are known: near a cell's border the table of rays decides",
                         "most reads of the table of rays"});
  if (plan.aperture.isPinhole && !plan.sumsTexels && job.state.psf.light == LightModel::linear)
    decisions.push_back(
        {"no decoding to linear light", "nothing is summed", "two conversions for each ray"});
  return decisions;
}

std::string oneLine(const RenderJob& job, const Plan& plan) {
  const int n = job.sampling.samplesPerPixel;
  const auto square = [](int width) { return std::to_string(width * width); };
  std::string line(nameOf(job.sampling.reconstruction));
  line += ", " + square(n) + (n == 1 ? " ray" : " rays") + " a pixel, ";
  if (!plan.aperture.isPinhole)
    line += std::to_string(plan.aperture.points.size()) + " samples of the pupil, ";
  if (job.state.psf.windowSize == 1)
    line += "no leakage, ";
  else
    line += square(2 * plan.psfReach + 1) + " of " + square(job.state.psf.windowSize) + " taps, ";
  if (!plan.hasLens) return line + "no lens";
  return line + (plan.isTableKept ? "lens table kept" : "lens row by row");
}

}  // namespace hogelscope
