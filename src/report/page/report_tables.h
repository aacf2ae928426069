// SPDX-License-Identifier: BSD-3-Clause
// Tables of the report's page, except the means (summary_page.h).
#pragma once

#include <string>
#include <vector>

#include "core/lens/lens_certificate.h"
#include "core/metrics/report_rows.h"

namespace hogelscope {

/// The lens of a state.
struct ReportLens {
  std::string state;
  LensCertificate certificate;
};

/// Returns a table with a row for each state and test.
std::string statesTable(const std::vector<ReportRow>& rows, const MetricSet& metrics);

/// Returns the table of lenses. States whose lenses have the same certificate share a row.
std::string lensesTable(const std::vector<ReportLens>& lenses);

/// Returns a text such as "a, b and 48 others".
std::string listed(const std::vector<std::string>& names);

}  // namespace hogelscope
