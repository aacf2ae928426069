// SPDX-License-Identifier: BSD-3-Clause
#include "study/instabilities.h"

#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

#include "core/light_field/light_field.h"
#include "core/metrics/summary.h"
#include "core/optics/psf.h"

namespace hogelscope {

namespace {

/// Returns the gain of a simulated white hogel with leakage.
double normalisedGain(const PsfParams& params) {
  constexpr int side = 32;
  constexpr std::uint8_t white = 255;
  const LightFieldSize size{1, 1, side, side};
  const LightField field(size, std::vector<std::uint8_t>(3 * size.width() * size.height(), white));
  return Psf(params).leaked(field, {0, 0, side / 2, side / 2}).g / white;
}

double paperGain(const PsfParams& params) {
  const int n = (params.windowSize - 1) / 2;
  const double variance = params.sigma * params.sigma;
  double axis = 0;  // the Gaussian is the product of both axes
  for (int x = -n; x <= n; ++x) axis += std::exp(-x * x / (2 * variance));
  return axis * axis / (2 * std::numbers::pi * variance);
}

/// Two images with a PSNR of 35.0 dB: `fives` values differ by 5, the others by 4.
struct NoisyPair {
  NoisyPair() : reference(64, 64), test(64, 64) {
    constexpr std::size_t fives = 6231;  // of 12288: MSE 20.563
    for (std::size_t k = 0; k < reference.rgb.size(); ++k) {
      reference.rgb[k] = std::uint8_t(20 + 37 * k % 200);
      test.rgb[k] = std::uint8_t(reference.rgb[k] + (k < fives ? 5 : 4));
    }
  }
  Image reference;
  Image test;
};

double openCvsPsnr(Image& a, Image& b) {
  return cv::PSNR(cv::Mat(a.height, a.width, CV_8UC3, a.rgb.data()),
                  cv::Mat(b.height, b.width, CV_8UC3, b.rgb.data()));
}

}  // namespace

std::vector<InstabilityRow> psfGains() {
  std::vector<InstabilityRow> rows;
  for (const double sigma : {0.1, 0.2, 0.3, 0.408, 0.5, 0.67, 0.946, 1.25, 1.5, 2.0, 3.0, 5.0}) {
    for (const int window : {1, 3, 5, 7, 9, 15, 31}) {
      const PsfParams params{sigma, window, PsfBorder::renormalise, LightModel::encoded};
      rows.push_back({"psf_gain", "normalised", sigma, window, {}, normalisedGain(params)});
      rows.push_back({"psf_gain", "paper eq. 5", sigma, window, {}, paperGain(params)});
    }
  }
  return rows;
}

std::vector<InstabilityRow> psnrMeans() {
  constexpr int views = 6;  // as in the paper's Table I
  NoisyPair pair;
  std::vector<InstabilityRow> rows;
  for (int identical = 0; identical < views; ++identical) {
    const MetricSet metrics;
    std::vector<ReportRow> report;
    double openCv = 0;
    for (int view = 0; view < views; ++view) {
      Image& test = view < identical ? pair.reference : pair.test;
      openCv += openCvsPsnr(pair.reference, test) / views;
      report.push_back({"", "", metrics.compare(pair.reference, test), {}});
    }
    const ReportSummary summary = summariseRows(report, metrics);
    const auto add = [&](const char* method, double value) {
      rows.push_back({"psnr_mean", method, double(views), double(identical), {}, value});
    };
    add("mean of cv::PSNR", openCv);
    add("mean of finite", summary.means[meanPsnr]);
    add("of mean MSE", summary.means[psnrOfMeanMse]);
  }
  return rows;
}

std::vector<InstabilityRow> measureInstabilities(const ParallelRows& parallelRows,
                                                 const Progress& progress) {
  std::vector<InstabilityRow> all = psfGains();
  for (const auto& rows : {psnrMeans(), viewErrors(parallelRows, progress)})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

}  // namespace hogelscope
