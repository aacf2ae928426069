// SPDX-License-Identifier: BSD-3-Clause
// Speed against accuracy: the reference, the statistics of the runs, the table.
#include "study/tradeoff.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.h"

namespace hogelscope {

Question questionOf(const SamplingParams& sampling) {
  return sampling.reconstruction == Reconstruction::nearest && sampling.samplesPerPixel == 1
             ? Question::displayAsBuilt
             : Question::idealPicture;
}

std::string questionText(Question question) {
  return question == Question::displayAsBuilt ? "the display as built" : "the ideal picture";
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
      "milliseconds_q25,spread,runs,timed_pixels,error_pixels\n";
  for (const TradeoffRow& row : rows) {
    for (const std::string& word : {row.method, row.lens, row.reconstruction, row.psf})
      text += "\"" + word + "\",";
    text += std::to_string(row.samples) + "," + std::to_string(row.scale) + "," + row.precision;
    for (const double value :
         {row.milliseconds, row.mraysPerSecond, row.rmse, row.psnr, row.maxError, row.seenMismatch})
      text += "," + numberText(value);
    text += row.isPareto ? ",1" : ",0";
    for (const double value : {row.fastest, row.upperQuartile, row.lowerQuartile, spreadOf(row),
                               double(row.runs), row.timedPixels, row.errorPixels})
      text += "," + numberText(value);
    text += "\n";
  }
  return text;
}

}  // namespace hogelscope
