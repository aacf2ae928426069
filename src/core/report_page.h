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

/// `report.html`. `session` is the document's name.
std::string reportPage(const std::vector<ReportRow>& rows, const std::vector<ReportLens>& lenses,
                       const std::string& session);

/// The summary, a line each.
std::string summaryText(const ReportSummary& summary, const std::vector<ReportRow>& rows);

}  // namespace hogelscope
