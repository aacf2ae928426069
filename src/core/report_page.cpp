// SPDX-License-Identifier: BSD-3-Clause
// The report as one self-contained page.
#include "core/report_page.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace hogelscope {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string rounded(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return "identical";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

namespace {

std::string tableRow(const ReportRow& row) {
  const Metrics& m = row.metrics;
  std::string text = "<tr><td>" + escaped(row.state) + "</td><td>" + escaped(row.test) + "</td>";
  for (const std::string& cell :
       {rounded(m.mse, 3), rounded(psnr(m.mse), 2), rounded(m.mseSeen, 3),
        rounded(psnr(m.mseSeen), 2), rounded(m.ssim, 4), rounded(100 * m.seen, 1)})
    text += "<td class=\"n\">" + cell + "</td>";
  return text + "</tr>\n";
}

constexpr const char* pageHead =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
    "<title>Hogelscope report</title>\n<style>\n"
    "body{font:15px/1.5 system-ui,sans-serif;max-width:70em;margin:2em auto;padding:0 1em}\n"
    "table{border-collapse:collapse}td,th{padding:.25em .8em;border-bottom:1px solid #ccc;"
    "text-align:left}\n.n{text-align:right;font-variant-numeric:tabular-nums}\n"
    "</style></head><body>\n";

}  // namespace

std::string summaryText(const ReportSummary& summary, const std::vector<ReportRow>& rows) {
  const auto decibels = [](double value) {
    return rounded(value, 2) + (std::isfinite(value) ? " dB" : "");
  };
  std::string text = "mean of the finite PSNRs  " + decibels(summary.meanFinitePsnr) + "\n" +
                     "PSNR of the mean MSE      " + decibels(summary.psnrOfMeanMse) + "\n";
  if (summary.worst) {
    const ReportRow& row = rows[*summary.worst];
    text += "worst view                " + decibels(psnr(row.metrics.mse)) + ": " + row.state +
            ", " + row.test + "\n";
  }
  return text + "identical views           " + std::to_string(summary.identical) + " of " +
         std::to_string(rows.size()) + "\n";
}

std::string reportPage(const std::vector<ReportRow>& rows, const std::vector<ReportLens>& lenses,
                       const std::string& session, const std::string& tables) {
  std::string text = pageHead;
  text += "<h1>Perceived views of " + escaped(session) + "</h1>\n<pre>" +
          escaped(summaryText(summarise(rows), rows)) + "</pre>\n" + tables;
  text +=
      "<p>MSE and PSNR on 8-bit RGB, over the whole picture and over the pixels seen in both; "
      "SSIM on luma.</p>\n<table><tr><th>state</th><th>test</th><th>MSE</th><th>PSNR dB</th>"
      "<th>MSE seen</th><th>PSNR seen dB</th><th>SSIM</th><th>seen %</th></tr>\n";
  for (const ReportRow& row : rows) text += tableRow(row);
  text +=
      "</table>\n<h2>How far the lenses can be trusted</h2>\n<table><tr><th>state</th>"
      "<th>lens</th></tr>\n";
  for (const ReportLens& lens : lenses)
    text += "<tr><td>" + escaped(lens.state) + "</td><td>" +
            escaped(hogelscope::text(lens.certificate)) + "</td></tr>\n";
  return text + "</table>\n</body></html>\n";
}

}  // namespace hogelscope
