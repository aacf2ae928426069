// SPDX-License-Identifier: BSD-3-Clause
// The files of a report.
#pragma once

#include <filesystem>
#include <vector>

#include "core/metrics/panel_error.h"
#include "report/page/report_page.h"
#include "report/report_request.h"
#include "report/view_pairs.h"

namespace hogelscope {

/// All that a report may write, but for the files by which it goes on.
std::vector<std::filesystem::path> filesOf(const ReportRequest& request);

/// FOLDER/reference/NAME.png of a state.
std::filesystem::path referenceImage(const std::filesystem::path& folder, const std::string& state);
/// FOLDER/testN/NAME.png of a state, N from 1.
std::filesystem::path testImage(const std::filesystem::path& folder, std::size_t test,
                                const std::string& state);

/// FOLDER/panel_error/testN_ENDING, N from 1.
std::filesystem::path panelFile(const std::filesystem::path& folder, std::size_t test,
                                const std::string& ending);

/// report.csv, metrics.csv, summary.csv, and bd.csv where there are groups.
void writeTables(const std::filesystem::path& folder, const Report& report,
                 const MetricSet& metrics);

/// Writes testImage(), and referenceImage() with the first test.
void writeImages(const std::filesystem::path& folder, std::size_t test, const std::string& state,
                 const ViewPair& pair, const Progress& progress);

/// FOLDER/panel_error/testN_hogels.exr and .png, testN_directions.exr and .png, and where there are
/// errors of views testN_views.exr and .png, testN_ranks.png; the images for the page, shrunk as
/// those of views are.
ReportPanel writePanelError(const std::filesystem::path& folder, std::size_t test,
                            const ReportRequest& request, const PanelError& error,
                            const std::vector<double>& viewErrors, const DisplayParams& display);

/// A view that the page shows: its row, its test and "worst", "median" or "best".
struct ChosenView {
  std::size_t row = 0;
  std::size_t test = 0;
  std::string which;
};

/// FOLDER/views/testN_WHICH_reference.png, …_test.png, …_difference.png; the same for the page,
/// where the pictures of `tests` tests have to stay within mostPictureBytes.
ReportView writeView(const std::filesystem::path& folder, const ChosenView& view, std::size_t tests,
                     const ViewPair& pair, const Progress& progress);

}  // namespace hogelscope
