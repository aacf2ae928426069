// SPDX-License-Identifier: BSD-3-Clause
// The report as a self-contained page.
// The page is made of text: SVG and tables need no library, and it is XML too, so that a test reads
// it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/metrics/summary.h"
#include "report/page/report_plots.h"
#include "report/page/report_tables.h"

namespace hogelscope {

/// The limit of the images in a page, in bytes of base64; they are scaled down to fit.
constexpr std::size_t mostPictureBytes = 8000000;

/// The three images of a row, each as a complete PNG file.
struct ReportView {
  std::size_t row = 0;  ///< an index of the report's rows
  std::string which;    ///< "worst", "median", "best"
  std::string reference;
  std::string test;
  std::string difference;
  int gain = 1;   ///< of the difference image
  int scale = 1;  ///< each pixel is the mean of scale × scale pixels of the files
  /// The files of all pixels, beside the page, without their endings "_reference.png" and others.
  std::string files{};
};

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
  std::vector<ReportPanel> panels;      ///< of each test
  std::vector<std::string> warnings{};  ///< sentences
  std::vector<std::string> notes{};     ///< sentences on the results
  bool isAgainstDesign = false;         ///< the tests are units of the display
  bool hasPage = false;                 ///< page.html stands beside it
};

/// Returns the figures of the page that are files too, in the page's order.
std::vector<Figure> figuresOf(const ReportPage& page);

/// Returns `report.html`: HTML that is well-formed XML, with embedded images, style and script.
/// Throws std::out_of_range if a view names no row.
std::string html(const ReportPage& page);

}  // namespace hogelscope
