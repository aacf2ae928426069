// SPDX-License-Identifier: BSD-3-Clause
// The report's rows as CSV, and what they amount to.
#include "core/metrics/report_rows.h"

#include <cmath>

#include "core/base/text.h"

namespace hogelscope {

MeanSums meanSums(const ReportRow& row, double weight) {
  const Metrics& m = row.metrics;
  MeanSums sums{};
  if (!row.problem.empty()) return sums;
  std::size_t at = 0;
  for (const double value : {psnr(m.mse), m.mse, m.ssim, psnr(m.mseYuv[0]), psnrYuv(m.mseYuv)}) {
    if (std::isfinite(value)) {
      sums[at] = weight * value;
      sums[at + 1] = weight;
    }
    at += 2;
  }
  return sums;
}

ReportMeans meansOf(const double* sums) {
  const auto mean = [sums](std::size_t figure) { return sums[2 * figure] / sums[2 * figure + 1]; };
  return {mean(0), psnr(mean(1)), mean(2), mean(3), mean(4)};
}

ReportSummary summarise(const std::vector<ReportRow>& rows) {
  ReportSummary summary;
  MeanSums sums{};
  MeanSums weighted{};
  for (std::size_t index = 0; index < rows.size(); ++index) {
    if (!rows[index].problem.empty()) {
      ++summary.withoutView;
      continue;
    }
    const MeanSums one = meanSums(rows[index], 1);
    const MeanSums weightedOne = meanSums(rows[index], rows[index].weight);
    for (std::size_t k = 0; k < sums.size(); ++k) {
      sums[k] += one[k];
      weighted[k] += weightedOne[k];
    }
    const double mse = rows[index].metrics.mse;
    if (mse == 0) ++summary.identical;
    if (mse > 0 && (!summary.worst || mse > rows[*summary.worst].metrics.mse))
      summary.worst = index;
  }
  static_cast<ReportMeans&>(summary) = meansOf(sums.data());
  summary.weighted = meansOf(weighted.data());
  return summary;
}

std::string csv(const std::vector<ReportRow>& rows) {
  std::string text = "state,test,mse,psnr,mse_seen,psnr_seen,ssim,seen,eye_x,eye_y,eye_z\n";
  for (const ReportRow& row : rows) {
    const Metrics& m = row.metrics;
    text += csvCell(row.state) + "," + csvCell(row.test);
    for (const double value : {m.mse, psnr(m.mse), m.mseSeen, psnr(m.mseSeen), m.ssim, m.seen,
                               row.eye.x, row.eye.y, row.eye.z})
      text += "," + numberText(value);
    text += "\n";
  }
  return text;
}

std::string metricsCsv(const std::vector<ReportRow>& rows) {
  std::string text =
      "state,test,mse_y,mse_cb,mse_cr,psnr_y,psnr_cb,psnr_cr,psnr_yuv,weight,problem\n";
  for (const ReportRow& row : rows) {
    const auto& [y, cb, cr] = row.metrics.mseYuv;
    text += csvCell(row.state) + "," + csvCell(row.test);
    for (const double value :
         {y, cb, cr, psnr(y), psnr(cb), psnr(cr), psnrYuv({y, cb, cr}), row.weight})
      text += "," + numberText(value);
    text += "," + csvCell(row.problem) + "\n";
  }
  return text;
}

}  // namespace hogelscope
