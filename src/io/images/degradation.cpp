// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/degradation.h"

#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/random_numbers.h"
#include "core/base/text.h"
#include "core/optics/image.h"
#include "io/images/codecs.h"

namespace hogelscope {

namespace {

using Kind = Degradation::Kind;

void throughJpeg(int quality, const cv::Mat& band, const Progress& progress) {
  constexpr int longest = 65488;  // the format's limit in whole blocks of 16
  for (int x = 0; x < band.cols; x += longest) {
    throwIfCancelled(progress);
    codecs().throughJpeg(quality, std::min(longest, band.cols - x), band.rows,
                         band.data + 3 * std::size_t(x), band.step);
  }
}

/// Computes SplitMix64 (Steele, Lea, Flood 2014) of a counter, so that any value can be computed
/// alone.
std::uint64_t mixed(std::uint64_t counter) {
  std::uint64_t z = counter * 0x9E3779B97F4A7C15U;
  z = (z ^ z >> 30U) * 0xBF58476D1CE4E5B9U;
  z = (z ^ z >> 27U) * 0x94D049BB133111EBU;
  return z ^ z >> 31U;
}

double normal(std::uint64_t counter) {
  return normalOf(unitOf(mixed(2 * counter)), unitOf(mixed(2 * counter + 1)));
}

void addNoise(double sigma, std::uint64_t start, std::span<std::uint8_t> band,
              const Progress& progress) {
  constexpr std::size_t piece = 65536;
  for (std::size_t k = 0; k < band.size(); ++k) {
    if (k % piece == 0) throwIfCancelled(progress);
    band[k] = quantised(band[k] + sigma * normal(start + k));
  }
}

void blurHogels(double sigma, const LightFieldSize& size, const cv::Mat& band,
                const Progress& progress) {
  for (int i = 0; i < size.nx; ++i) {
    throwIfCancelled(progress);
    const cv::Mat hogel = band.colRange(i * size.du, (i + 1) * size.du);
    cv::Mat blurred;
    cv::GaussianBlur(hogel.clone(), blurred, {}, sigma, sigma, cv::BORDER_REPLICATE);
    blurred.copyTo(hogel);
  }
}

}  // namespace

Degradation parseDegradation(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::string number = colon == std::string::npos ? "" : text.substr(colon + 1);
  Degradation result;
  const std::optional<double> amount = numberOf(number);
  result.amount = amount.value_or(0);
  const auto within = [&](double least, double most) {
    if (!amount || !(*amount >= least && *amount <= most))
      throw InputError("degradation", text,
                       "needs a number from " + std::to_string(int(least)) + " to " +
                           std::to_string(int(most)) + " after " + name + ":");
  };
  if (name == "jpeg") {
    result.kind = Kind::jpeg;
    within(1, 100);
  } else if (name == "noise") {
    result.kind = Kind::noise;
    within(0, 255);
  } else if (name == "blur") {
    result.kind = Kind::blur;
    within(0, 100);
  } else {
    throw InputError("degradation", text, "is not jpeg:QUALITY, noise:SIGMA or blur:SIGMA");
  }
  return result;
}

void degrade(const Degradation& degradation, const LightFieldSize& size, int j,
             std::span<std::uint8_t> band, const Progress& progress) {
  const cv::Mat mat(size.dv, int(size.width()), CV_8UC3, band.data());
  switch (degradation.kind) {
    case Kind::jpeg:
      return throughJpeg(int(degradation.amount), mat, progress);
    case Kind::noise:
      return addNoise(degradation.amount, mixed(degradation.seed) + std::uint64_t(j) * band.size(),
                      band, progress);
    case Kind::blur:
      if (degradation.amount > 0) blurHogels(degradation.amount, size, mat, progress);
      return;
    case Kind::none:
      return;
  }
}

}  // namespace hogelscope
