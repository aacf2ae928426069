// SPDX-License-Identifier: BSD-3-Clause
// Speed against accuracy: the compared methods, the reference, the statistics of the runs, the
// table.
#include "study/tradeoff.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/base/text.h"
#include "core/engine/plan.h"
#include "core/optics/distortion.h"

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
  if (!haveLens(views))
    std::erase_if(methods, [](const NamedMethod& m) {
      return m.mapping != exactly || m.method.lens != Method{}.lens;
    });
  if (havePupil(views)) std::ranges::move(pupilMethods(), std::back_inserter(methods));
  return methods;
}

bool haveLens(const std::vector<RenderJob>& views) {
  return std::ranges::any_of(
      views, [](const RenderJob& job) { return !Distortion(job.state.distortion).isIdentity(); });
}

bool havePupil(const std::vector<RenderJob>& views) {
  return std::ranges::any_of(views,
                             [](const RenderJob& job) { return !plan(job).aperture.isPinhole; });
}

std::vector<NamedMethod> pupilMethods() {
  std::vector<NamedMethod> methods{{.name = "pinhole", .pupilSamples = 0}};
  for (const AperturePattern pattern :
       {AperturePattern::vogel, AperturePattern::grid, AperturePattern::random})
    for (const int samples : {4, 12, 32, 52, 112})  // as many as a grid in the disc has
      methods.push_back({.name = std::string(nameOf(pattern)) + " " + std::to_string(samples),
                         .method = {.aperture = pattern},
                         .pupilSamples = samples});
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

Question questionOf(const SamplingParams& sampling) {
  return sampling.reconstruction == Reconstruction::nearest && sampling.samplesPerPixel == 1
             ? Question::displayAsBuilt
             : Question::idealPicture;
}

void ask(Question question, std::vector<RenderJob>& views) {
  for (RenderJob& job : views)
    if (questionOf(job.sampling) != question)
      job.sampling = {.reconstruction =
                          question == Question::displayAsBuilt ? nearest : quadrilinear};
}

std::string questionText(Question question) {
  return question == Question::displayAsBuilt ? "the exact pixels" : "the smooth ideal";
}

std::string details(Question question) {
  return question == Question::displayAsBuilt
             ? "exact lens, full window, nearest, one ray a pixel, double precision"
             : "exact lens, full window, quadrilinear, 8×8 rays a pixel, double precision";
}

RenderJob applyMethod(const NamedMethod& method, const RenderJob& job) {
  RenderJob result = job;
  result.sampling = {method.mapping, method.reconstruction, method.samplesPerPixel};
  result.method = method.method;
  if (method.pupilSamples == 0) result.state.pupil = {};
  if (method.pupilSamples) result.state.pupil.samples = *method.pupilSamples;
  return result;
}

void setTimes(TradeoffRow& row, std::vector<double> runs) {
  std::sort(runs.begin(), runs.end());
  const std::size_t count = runs.size();
  row.milliseconds = (runs[(count - 1) / 2] + runs[count / 2]) / 2;
  row.fastest = runs.front();
  const std::size_t quarter = count - (3 * count + 3) / 4;
  row.lowerQuartile = runs[quarter];
  row.upperQuartile = runs[count - 1 - quarter];
  row.runs = int(count);
}

double spreadOf(const TradeoffRow& row) {
  if (row.runs < 2) return std::numeric_limits<double>::quiet_NaN();
  return 1.57 * (row.upperQuartile - row.lowerQuartile) / std::sqrt(row.runs) / row.milliseconds;
}

std::pair<double, double> errorRangeOf(const TradeoffRow& row) {
  const auto rmse = [](double psnr) { return 255 * std::pow(10, -psnr / 20); };
  return {rmse(row.psnrHigh), rmse(row.psnrLow)};
}

void markPareto(std::vector<TradeoffRow>& rows) {
  for (TradeoffRow& row : rows)
    row.isPareto = std::none_of(rows.begin(), rows.end(), [&row](const TradeoffRow& other) {
      return other.milliseconds <= row.milliseconds && other.rmse <= row.rmse &&
             (other.milliseconds < row.milliseconds || other.rmse < row.rmse);
    });
}

std::string csv(const std::vector<TradeoffRow>& rows) {
  std::string text =
      "method,lens,reconstruction,psf,samples,scale,precision,milliseconds,mrays_per_s,rmse,psnr,"
      "max_error,seen_mismatch,pareto,milliseconds_min,milliseconds_q75,"
      "milliseconds_q25,spread,runs,timed_pixels,error_pixels,psnr_low,psnr_high\n";
  for (const TradeoffRow& row : rows) {
    for (const std::string& word : {row.method, row.lens, row.reconstruction, row.psf})
      text += "\"" + word + "\",";
    text += std::to_string(row.samples) + "," + std::to_string(row.scale) + "," + row.precision;
    for (const double value :
         {row.milliseconds, row.mraysPerSecond, row.rmse, row.psnr, row.maxError, row.seenMismatch})
      text += "," + numberText(value);
    text += row.isPareto ? ",1" : ",0";
    for (const double value :
         {row.fastest, row.upperQuartile, row.lowerQuartile, spreadOf(row), double(row.runs),
          row.timedPixels, row.errorPixels, row.psnrLow, row.psnrHigh})
      text += "," + numberText(value);
    text += "\n";
  }
  return text;
}

}  // namespace hogelscope
