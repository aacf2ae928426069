// SPDX-License-Identifier: BSD-3-Clause
// The standard metrics, and those of a set side by side.
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

/// In the order of MetricIndex, then those that only files and the page have.
std::vector<MetricColumn> standardColumnList() {
  const char* const seenHelp =
      "Share of the image's pixels that see the display in both images; how much of the panel "
      "lights the eye, under the 3-D scene, is another figure";
  return {
      {"psnr", "PSNR", "dB", "Over the whole image; higher is closer to the reference", 2, 1,
       Where::window},
      {"psnr_seen", "PSNR seen", "dB", "Over the pixels that see the display in both images", 2, 1,
       Where::window},
      {"mse", "MSE", "", "Mean squared error over the whole image", 3, 1, Where::page},
      {"mse_seen", "MSE seen", "", "Over the pixels that see the display in both images", 3, 1,
       Where::page},
      {"ssim", "SSIM", "", "Structural similarity of the luma, 1 for identical images", 4, 1,
       Where::window},
      {"seen", "Seen", "%", seenHelp, 1, 100, Where::window},
      {.name = "mse_y"},
      {.name = "mse_cb"},
      {.name = "mse_cr"},
      {"psnr_y", "PSNR\u2011Y", "dB", "Of the luma of BT.709", 2, 1, Where::page},
      {.name = "psnr_cb"},
      {.name = "psnr_cr"},
      {"psnr_yuv", "PSNR\u2011YUV", "dB", "(6 PSNR-Y + PSNR-Cb + PSNR-Cr) / 8", 2, 1, Where::page}};
}

/// In the order of MeanIndex.
std::vector<MetricMean> standardMeans() {
  constexpr std::size_t psnrYColumn = 9, psnrYuvColumn = 12;
  return {{"mean_psnr", "mean PSNR", psnrColumn, 2, nullptr, true},
          {"psnr_of_mean_mse", "PSNR of mean MSE", mseColumn, 2, psnr, false},
          {"mean_ssim", "mean SSIM", ssimColumn, 4, nullptr, false},
          {"mean_psnr_y", "mean PSNR\u2011Y", psnrYColumn, 2, nullptr, true},
          {"mean_psnr_yuv", "mean PSNR\u2011YUV", psnrYuvColumn, 2, nullptr, true}};
}

std::vector<double> compareStandard(const Image& reference, const Image& test,
                                    const ParallelRows& parallelRows, const Progress& progress) {
  const SquaredError error = squaredError(reference, test, progress);
  const auto& [y, cb, cr] = error.mseYuv;
  return {psnr(error.mse),
          psnr(error.mseSeen),
          error.mse,
          error.mseSeen,
          ssim(reference, test, parallelRows, progress),
          error.seen,
          y,
          cb,
          cr,
          psnr(y),
          psnr(cb),
          psnr(cr),
          psnrYuv(error.mseYuv)};
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

std::vector<double> MetricSet::compare(const Image& reference, const Image& test,
                                       const ParallelRows& parallelRows,
                                       const Progress& progress) const {
  if (reference.width != test.width || reference.height != test.height)
    throw std::invalid_argument("compare: images of different sizes");
  const Progress polled = forThreads(progress);
  std::vector<double> values;
  for (const Metric& metric : m_metrics)
    std::ranges::copy(metric.compare(reference, test, parallelRows, polled),
                      std::back_inserter(values));
  return values;
}

std::vector<double> MetricSet::noValues() const {
  std::vector<double> values(m_columns.size(), std::numeric_limits<double>::quiet_NaN());
  values[seenColumn] = 0;
  return values;
}

}  // namespace hogelscope
