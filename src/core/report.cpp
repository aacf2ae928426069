// SPDX-License-Identifier: BSD-3-Clause
// The report's rows as CSV, and what they amount to.
#include "core/report.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace hogelscope {

namespace {

/// Would a spreadsheet take the text for a formula? A number is none, whatever its sign.
bool isFormula(const std::string& text) {
  static const std::array<std::string_view, 11> beginnings{"=",  "+",  "-",  "@",  "\t", "\r",
                                                           "\n", "＝", "＋", "－", "＠"};
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (stop == end && error == std::errc()) return false;
  return std::ranges::any_of(beginnings,
                             [&text](std::string_view sign) { return text.starts_with(sign); });
}

}  // namespace

std::string csvCell(const std::string& text) {
  std::string harmless = isFormula(text) ? "'" + text : text;
  if (harmless.find_first_of(",\"\r\n") == std::string::npos) return harmless;
  std::string cell = "\"";
  for (const char c : harmless) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

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

std::string numberText(double value) {
  if (std::isnan(value)) return "nan";  // to_chars may write -nan
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string bytesText(std::size_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " bytes";
  const auto tenths = [bytes](double unit) { return std::round(10 * double(bytes) / unit) / 10; };
  for (const auto& [unit, name] : {std::pair(1e3, " kB"), std::pair(1e6, " MB")})
    if (tenths(unit) < 1000) return numberText(tenths(unit)) + name;
  return numberText(tenths(1e9)) + " GB";
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
