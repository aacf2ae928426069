// SPDX-License-Identifier: BSD-3-Clause
// The report as one self-contained page: last on the line, in the line's order.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/summary.h"
#include "report/page/report_images.h"
#include "report/page/report_tables.h"

namespace hogelscope {

/// A line of "what was tested".
struct ReportFact {
  std::string name;
  std::string value;
};

/// Lists that are empty leave no heading.
struct ReportPage {
  std::string session;  ///< what it is called: its document's name, if it has one
  std::vector<ReportFact> facts;
  DisplayParams display;  ///< with its hogels and directions
  MetricSet metrics;
  std::vector<ReportRow> rows;
  std::vector<TestSummary> summaries;
  std::vector<BdRow> comparisons;
  std::vector<RateGroup> groups;
  std::vector<ReportLens> lenses;
  std::vector<ReportView> views;
  std::vector<ReportPanel> panels;
};

/// `report.html`: HTML that is well-formed XML, with its images, style and script inside. Throws
/// std::out_of_range where a view names no row.
std::string html(const ReportPage& page);

}  // namespace hogelscope
