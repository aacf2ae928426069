// SPDX-License-Identifier: BSD-3-Clause
// The summary as text, for the terminal and the report's page.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/summary.h"

namespace hogelscope {

/// Returns the summary, one line each.
std::string summaryText(const ReportSummary& summary, const std::vector<ReportRow>& rows);

/// Returns the BD-rates, one line each.
std::string bdText(const std::vector<BdRow>& rows);

/// Returns the means of every test as HTML. The last summary is the one of all tests.
std::string summaryTables(const std::vector<TestSummary>& summaries, const MetricSet& metrics);

/// Returns the BD-rates as HTML.
std::string bdTable(const std::vector<BdRow>& rows);

}  // namespace hogelscope
