// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/flicker.h"

#include <limits>
#include <stdexcept>

#include "core/metrics/squared_error.h"

namespace hogelscope {

FrameDifference frameDifference(const Image& reference, const Image& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw std::invalid_argument("frameDifference: images of two sizes");
  FrameDifference difference;
  difference.values.reserve(reference.rgb.size());
  const auto width = 3 * std::size_t(reference.width);
  std::vector<double> ours(width), others(width);
  for (std::size_t at = 0; at < reference.rgb.size(); at += width) {
    readCodeValues(reference, at, ours);
    readCodeValues(test, at, others);
    for (std::size_t k = 0; k < width; ++k) difference.values.push_back(float(others[k] - ours[k]));
  }
  difference.seen.resize(reference.seen.size());
  for (std::size_t k = 0; k < difference.seen.size(); ++k)
    difference.seen[k] = reference.seen[k] & test.seen[k];
  return difference;
}

FlickerError flickerError(const FrameDifference& before, const FrameDifference& after) {
  if (before.values.size() != after.values.size())
    throw std::invalid_argument("flickerError: images of two sizes");
  double all = 0, seen = 0;
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < after.seen.size(); ++pixel) {
    double square = 0;
    for (std::size_t k = 3 * pixel; k < 3 * pixel + 3; ++k) {
      const double change = double(after.values[k]) - double(before.values[k]);
      square += change * change;
    }
    all += square;
    if (before.seen[pixel] == 0 || after.seen[pixel] == 0) continue;
    seen += square;
    ++count;
  }
  return {all / double(after.values.size()), seen / double(3 * count)};
}

Metric flickerMetric() {
  Metric metric;
  metric.columns = {{.name = "flicker_mse"}, {.name = "flicker_mse_seen"}};
  const auto mean = [](const char* name, std::size_t column, bool isSeen) {
    return MetricMean{.name = name,
                      .title = "flicker PSNR",
                      .column = column,
                      .ofMean = psnr,
                      .unit = "dB",
                      .isSeen = isSeen};
  };
  metric.means = {mean("flicker_psnr", 0, false), mean("flicker_psnr_seen", 1, true)};
  metric.compare = [](const Image&, const Image&, const ParallelRows&, const Progress&,
                      const Viewing&) {
    return std::vector<double>(2, std::numeric_limits<double>::quiet_NaN());
  };
  return metric;
}

std::vector<double> flickerValues(const FlickerError& error) {
  return {error.mse, error.mseSeen};
}

}  // namespace hogelscope
