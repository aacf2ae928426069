// SPDX-License-Identifier: BSD-3-Clause
// The summary in words, for the terminal and the report's page.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/summary.h"

namespace hogelscope {

/// The summary, a line each.
std::string summaryText(const ReportSummary& summary, const std::vector<ReportRow>& rows);

/// BD-rates, a line each.
std::string bdText(const std::vector<BdRow>& rows);

/// The figures of every test as HTML. The last summary is that over all.
std::string summaryTables(const std::vector<TestSummary>& summaries, const MetricSet& metrics);

/// BD-rates as HTML.
std::string bdTable(const std::vector<BdRow>& rows);

}  // namespace hogelscope
