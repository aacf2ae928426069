// SPDX-License-Identifier: BSD-3-Clause
// The report as a self-contained page.
// The page is made of text: SVG and tables need no library, and it is XML too, so that a test reads
// it.
#pragma once

#include <string>
#include <vector>

#include "core/lens/lens_certificate.h"
#include "core/metrics/report_rows.h"
#include "core/metrics/summary.h"
#include "report/page/report_images.h"

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

/// A line of the section "what was tested".
struct ReportFact {
  std::string name;
  std::string value;
};

/// The contents of the page. Empty lists have no heading.
struct ReportPage {
  std::string session;  ///< the name, from its document's name if it has one
  std::vector<ReportFact> facts;
  PanelParams display;  ///< with its hogel and direction counts
  MetricSet metrics;
  std::vector<ReportRow> rows;
  std::vector<TestSummary> summaries;
  std::vector<BdRow> comparisons;
  std::vector<RateGroup> groups;
  std::vector<ReportLens> lenses;
  std::vector<ReportView> views;
  std::vector<ReportPanel> panels;
};

/// Returns `report.html`: HTML that is well-formed XML, with embedded images, style and script.
/// Throws std::out_of_range if a view names no row.
std::string html(const ReportPage& page);

}  // namespace hogelscope
