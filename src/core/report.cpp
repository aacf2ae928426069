// SPDX-License-Identifier: BSD-3-Clause
// The report's rows as CSV, and what they amount to.
#include "core/report.h"

#include <charconv>
#include <cmath>

namespace hogelscope {

std::string csvCell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

ReportSummary summarise(const std::vector<ReportRow>& rows) {
  ReportSummary summary;
  double psnrSum = 0;
  double mseSum = 0;
  std::size_t finite = 0;
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const double mse = rows[index].metrics.mse;
    mseSum += mse;
    if (mse == 0) {
      ++summary.identical;
      continue;
    }
    psnrSum += psnr(mse);
    ++finite;
    if (!summary.worst || mse > rows[*summary.worst].metrics.mse) summary.worst = index;
  }
  summary.meanFinitePsnr = psnrSum / double(finite);
  summary.psnrOfMeanMse = psnr(mseSum / double(rows.size()));
  return summary;
}

std::string numberText(double value) {
  if (std::isnan(value)) return "nan";  // to_chars may write -nan
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
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

}  // namespace hogelscope
