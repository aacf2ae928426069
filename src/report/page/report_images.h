// SPDX-License-Identifier: BSD-3-Clause
// Images of the report's page: chosen views side by side, and the error on the panel.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/metrics/panel_error_figures.h"
#include "core/metrics/report_rows.h"
#include "core/metrics/view_error.h"

namespace hogelscope {

/// The limit of the images in a page, in bytes of base64; they are scaled down to fit.
constexpr std::size_t mostPictureBytes = 3000000;

/// The three images of a row, each as a complete PNG file.
struct ReportView {
  std::size_t row = 0;  ///< an index of the report's rows
  std::string which;    ///< "worst", "median", "best"
  std::string reference;
  std::string test;
  std::string difference;
  int gain = 1;   ///< of the difference image
  int scale = 1;  ///< each pixel is the mean of scale × scale pixels of the files
};

/// A test's error over the hogels and over the directions, each as a complete PNG file.
struct ReportPanel {
  std::string test;
  std::string hogels;
  std::string directions;
  PanelErrorFigures figures;
  /// The error of the light field's own views, and the difference of its ranks to the perceived
  /// one; empty unless both light fields are completely in memory.
  std::string views{};
  std::string ranks{};
  double viewScale = 0;  ///< MSE at the end of the colour scale of `views`
  ViewAgreement agreement{};
};

/// Returns the figures of the views. Throws std::out_of_range if a view names no row.
std::string viewFigures(const std::vector<ReportView>& views, const std::vector<ReportRow>& rows);

std::string panelFigures(const std::vector<ReportPanel>& panels, const DisplayParams& display);

}  // namespace hogelscope
