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

/// Returns a text such as "31.20 dB (30.95 … 31.44)"; without an interval that is not known.
std::string withRange(double value, const Interval& interval, int digits, const std::string& unit);

/// Returns the summary, one line each.
std::string summaryText(const ReportSummary& summary, const std::vector<ReportRow>& rows);

/// Returns a line for each test, with weighted means where states have weights.
std::string testsText(const std::vector<TestSummary>& summaries);

/// Returns the BD-rates of the headlines, one line each.
std::string bdText(const std::vector<BdRow>& rows, const MetricSet& metrics);

/// Returns the means of every test over the seen pixels, or over the whole frame, as HTML: weighted
/// ones first where states have weights. The last summary, of all tests, is left out.
std::string meansTable(const std::vector<TestSummary>& summaries, const MetricSet& metrics);
std::string frameTable(const std::vector<TestSummary>& summaries, const MetricSet& metrics);
/// Returns meansTable() as LaTeX, with weighted means alone where states have weights.
std::string meansTex(const std::vector<TestSummary>& summaries, const MetricSet& metrics);

/// Returns the BD-rates of the headlines as HTML, and as LaTeX.
std::string bdTable(const std::vector<BdRow>& rows, const MetricSet& metrics);
std::string bdTex(const std::vector<BdRow>& rows, const MetricSet& metrics);

/// Returns a table with a row for each state and test.
std::string statesTable(const std::vector<ReportRow>& rows, const MetricSet& metrics);

/// Returns the table of lenses. States whose lenses have the same certificate share a row.
std::string lensesTable(const std::vector<ReportLens>& lenses);

/// Returns a text such as "a, b and 48 others".
std::string listed(const std::vector<std::string>& names);

}  // namespace hogelscope
