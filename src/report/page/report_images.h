// SPDX-License-Identifier: BSD-3-Clause
// The images of the report's page: chosen views beside each other, the error on the panel.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/metrics/panel_error_figures.h"
#include "core/metrics/report_rows.h"
#include "core/metrics/view_error.h"

namespace hogelscope {

/// The pictures in a page are shrunk until their bytes, as base64, stay within this.
constexpr std::size_t mostPictureBytes = 3000000;

/// Three images of a row, whole PNG files' bytes.
struct ReportView {
  std::size_t row = 0;  ///< of the report's rows
  std::string which;    ///< "worst", "median", "best"
  std::string reference;
  std::string test;
  std::string difference;
  int gain = 1;   ///< of the difference image
  int scale = 1;  ///< each pixel is the mean of scale × scale pixels of the files
};

/// A test's error over the hogels and over the directions, whole PNG files' bytes.
struct ReportPanel {
  std::string test;
  std::string hogels;
  std::string directions;
  PanelErrorFigures figures;
  /// The error of the light field's own views, and where the perceived one ranks otherwise; empty
  /// where not both light fields are whole in memory.
  std::string views{};
  std::string ranks{};
  double viewScale = 0;  ///< MSE at the end of the colours of `views`
  ViewAgreement agreement{};
};

/// Throws std::out_of_range where a view names no row.
std::string viewFigures(const std::vector<ReportView>& views, const std::vector<ReportRow>& rows);

std::string panelFigures(const std::vector<ReportPanel>& panels, const DisplayParams& display);

}  // namespace hogelscope
