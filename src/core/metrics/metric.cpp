// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/metric.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/metrics/squared_error.h"
#include "core/metrics/ssim.h"

namespace hogelscope {

namespace {

using Where = MetricColumn::Where;

/// Returns the columns in the order of MetricIndex.
std::vector<MetricColumn> standardColumnList() {
  const char* const seenHelp =
      "Share of the image's pixels that see the display in both images; how much of the panel "
      "lights the eye, under the 3-D scene, is another figure";
  const char* const psnrHelp =
      "Over the pixels that see the display in both images; higher is closer to the reference";
  return {{"psnr_seen", "PSNR seen", "dB", psnrHelp, 2, 1, Where::window},
          {"psnr", "PSNR frame", "dB", "Over the whole image with its black surroundings", 2, 1,
           Where::window},
          {"mse_seen", "MSE seen", "", "Mean squared error of those pixels", 3, 1, Where::page},
          {"mse", "MSE frame", "", "Mean squared error over the whole image", 3, 1, Where::page},
          {"ssim", "SSIM frame", "", "Structural similarity of the luma, 1 for identical images", 4,
           1, Where::page},
          {"seen", "Seen", "%", seenHelp, 1, 100, Where::window},
          {.name = "mse_y"},
          {.name = "mse_cb"},
          {.name = "mse_cr"},
          {.name = "psnr_y"},
          {.name = "psnr_cb"},
          {.name = "psnr_cr"},
          {.name = "psnr_yuv"},
          {.name = "mse_y_seen"},
          {.name = "mse_cb_seen"},
          {.name = "mse_cr_seen"},
          {"psnr_y_seen", "PSNR\u2011Y seen", "dB", "Of the luma of BT.709", 2, 1, Where::page},
          {.name = "psnr_cb_seen"},
          {.name = "psnr_cr_seen"},
          {"psnr_yuv_seen", "PSNR\u2011YUV seen", "dB", "(6 PSNR-Y + PSNR-Cb + PSNR-Cr) / 8", 2, 1,
           Where::page},
          {"ssim_seen", "SSIM seen", "", "Of the windows that hold only pixels seen in both images",
           4, 1, Where::window},
          {.name = "bits"},
          {.name = "mse_of_bits"}};
}

/// Returns the means in the order of MeanIndex.
std::vector<MetricMean> standardMeans() {
  return {{"mean_psnr", "mean PSNR", psnrColumn, 2, nullptr, true, "dB"},
          {"psnr_of_mean_mse", "PSNR of mean MSE", mseColumn, 2, psnr, false, "dB"},
          {"mean_ssim", "mean SSIM", ssimColumn, 4, nullptr, true},
          {"mean_psnr_y", "mean PSNR\u2011Y", psnrYColumn, 2, nullptr, true, "dB"},
          {"mean_psnr_yuv", "mean PSNR\u2011YUV", psnrYuvColumn, 2, nullptr, true, "dB"},
          {"mean_psnr_seen", "mean PSNR", psnrSeenColumn, 2, nullptr, true, "dB", true},
          {"psnr_of_mean_mse_seen", "PSNR of mean MSE", mseSeenColumn, 2, psnr, false, "dB", true},
          {"mean_ssim_seen", "mean SSIM", ssimSeenColumn, 4, nullptr, true, "", true},
          {"mean_psnr_y_seen", "mean PSNR\u2011Y", psnrYSeenColumn, 2, nullptr, true, "dB", true},
          {"mean_psnr_yuv_seen", "mean PSNR\u2011YUV", psnrYuvSeenColumn, 2, nullptr, true, "dB",
           true}};
}

std::vector<double> compareStandard(const Image& reference, const Image& test,
                                    const ParallelRows& parallelRows, const Progress& progress,
                                    const Viewing& /*viewing*/) {
  const SquaredError error = squaredError(reference, test, progress);
  const Ssim similarity = ssim(reference, test, parallelRows, progress);
  std::vector<double> values{psnr(error.mseSeen), psnr(error.mse),  error.mseSeen,
                             error.mse,           similarity.frame, error.seen};
  for (const auto& mseYuv : {error.mseYuv, error.mseYuvSeen}) {
    values.insert(values.end(), mseYuv.begin(), mseYuv.end());
    for (const double mse : mseYuv) values.push_back(psnr(mse));
    values.push_back(psnrYuv(mseYuv));
  }
  const int bits = std::max(reference.bits, test.bits);
  const double unit = largestValue(bits) / 255.0;
  values.insert(values.end(), {similarity.seen, double(bits), error.mse * unit * unit});
  return values;
}

}  // namespace

std::string tableText(const MetricColumn& column, double value) {
  return rounded(column.tableFactor * value, column.decimals);
}

MetricSet::MetricSet(std::vector<Metric> others)
    : m_metrics{{standardColumnList(), standardMeans(), compareStandard}} {
  std::move(others.begin(), others.end(), std::back_inserter(m_metrics));
  for (const Metric& metric : m_metrics) {
    for (MetricMean mean : metric.means) {
      mean.column += m_columns.size();
      m_means.push_back(mean);
    }
    m_columns.insert(m_columns.end(), metric.columns.begin(), metric.columns.end());
  }
}

bool MetricSet::isHeadline(std::size_t mean) const {
  if (m_means[mean].isSeen) return true;
  const bool isStandard = mean <= meanPsnrYuvSeen;
  return !isStandard && std::ranges::find(m_means, m_means[mean].name + "_seen",
                                          &MetricMean::name) == m_means.end();
}

bool MetricSet::readUnrounded() const {
  return std::ranges::any_of(m_metrics, &Metric::readsUnrounded);
}

std::vector<double> MetricSet::compare(const Image& reference, const Image& test,
                                       const ParallelRows& parallelRows, const Progress& progress,
                                       const Viewing& viewing) const {
  if (reference.width != test.width || reference.height != test.height)
    throw std::invalid_argument("compare: images of different sizes");
  const Progress polled = forThreads(progress);
  std::vector<double> values;
  for (const Metric& metric : m_metrics)
    std::ranges::copy(metric.compare(reference, test, parallelRows, polled, viewing),
                      std::back_inserter(values));
  return values;
}

std::vector<double> MetricSet::noValues() const {
  std::vector<double> values(m_columns.size(), std::numeric_limits<double>::quiet_NaN());
  values[seenColumn] = 0;
  return values;
}

}  // namespace hogelscope
