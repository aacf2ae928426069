// SPDX-License-Identifier: BSD-3-Clause
// Tables of the report's page, and the summary as text for the terminal.
#pragma once

#include <string>
#include <vector>

#include "core/lens/lens_certificate.h"
#include "core/metrics/summary.h"

namespace hogelscope {

/// The lens of a state.
struct ReportLens {
  std::string state;
  LensCertificate certificate;
};

/// Returns the summary, one line each.
std::string summaryText(const ReportSummary& summary, const std::vector<ReportRow>& rows);

/// Returns the BD-rates, one line each.
std::string bdText(const std::vector<BdRow>& rows);

/// Returns the means of every test as HTML. The last summary is the one of all tests.
std::string summaryTables(const std::vector<TestSummary>& summaries, const MetricSet& metrics);

/// Returns the BD-rates as HTML.
std::string bdTable(const std::vector<BdRow>& rows);

/// Returns a table with a row for each state and test.
std::string statesTable(const std::vector<ReportRow>& rows, const MetricSet& metrics);

/// Returns the table of lenses. States whose lenses have the same certificate share a row.
std::string lensesTable(const std::vector<ReportLens>& lenses);

/// Returns a text such as "a, b and 48 others".
std::string listed(const std::vector<std::string>& names);

}  // namespace hogelscope
