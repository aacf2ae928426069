// SPDX-License-Identifier: BSD-3-Clause
// The report as one self-contained page, and its summary in words.
#pragma once

#include <string>
#include <vector>

#include "core/lens_certificate.h"
#include "core/report.h"

namespace hogelscope {

/// A state's lens.
struct ReportLens {
  std::string state;
  LensCertificate certificate;
};

/// `report.html`. `session` is the document's name; `tables` is HTML that follows the summary.
std::string reportPage(const std::vector<ReportRow>& rows, const std::vector<ReportLens>& lenses,
                       const std::string& session, const std::string& tables = {});

/// A text in HTML.
std::string escaped(const std::string& text);

/// With so many digits after the point; "identical" if infinite, a dash if not a number.
std::string rounded(double value, int digits);

/// The summary, a line each.
std::string summaryText(const ReportSummary& summary, const std::vector<ReportRow>& rows);

}  // namespace hogelscope
