// SPDX-License-Identifier: BSD-3-Clause
// The tables of the report's page but for the means (summary_page.h).
#pragma once

#include <string>
#include <vector>

#include "core/lens/lens_certificate.h"
#include "core/metrics/report_rows.h"

namespace hogelscope {

/// A state's lens.
struct ReportLens {
  std::string state;
  LensCertificate certificate;
};

/// A row for each state and test.
std::string statesTable(const std::vector<ReportRow>& rows, const MetricSet& metrics);

/// States whose lenses have the same certificate share a row.
std::string lensesTable(const std::vector<ReportLens>& lenses);

/// "a, b and 48 others".
std::string listed(const std::vector<std::string>& names);

}  // namespace hogelscope
