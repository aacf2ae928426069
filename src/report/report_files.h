// SPDX-License-Identifier: BSD-3-Clause
// Output files of a report.
#pragma once

#include <filesystem>
#include <vector>

#include "core/metrics/panel_error.h"
#include "io/images/comparison_sheet.h"
#include "report/page/report_page.h"
#include "report/report_request.h"
#include "report/view_pairs.h"

namespace hogelscope {

/// Returns all files that a report may write, except those for resuming.
std::vector<std::filesystem::path> filesOf(const ReportRequest& request);

/// Returns FOLDER/panel_error/testN_ENDING, N from 1.
std::filesystem::path panelFile(const std::filesystem::path& folder, std::size_t test,
                                const std::string& ending);

/// Writes report.csv, metrics.csv, summary.csv and plots/means.tex, and bd.csv and plots/bd.tex if
/// there are groups.
void writeTables(const std::filesystem::path& folder, const Report& report,
                 const MetricSet& metrics);

/// Returns the files that show a state of a test if they are there: reference, test and, if the
/// state is among those of `views`, their difference. `rows` are those of the folder's report.
std::vector<std::filesystem::path> picturesOf(const std::filesystem::path& folder,
                                              const std::vector<ReportRow>& rows,
                                              const ReportOrder& order, std::size_t row);

/// Returns a test's states without those that have a problem, from the worst view to the best.
std::vector<std::size_t> worstFirst(const std::vector<ReportRow>& rows, const ReportOrder& order,
                                    std::size_t test);

/// Returns the name of a row's pictures: its state's, or "STATE.frame0010".
std::string pictureName(const std::vector<ReportRow>& rows, std::size_t row);

/// Writes a view's FOLDER/testN/NAME.png, N from 1, and for the first test
/// FOLDER/reference/NAME.png.
void writeImages(const std::filesystem::path& folder, std::size_t test, const std::string& name,
                 const ViewPair& pair, const Progress& progress);

/// Writes FOLDER/panel_error/testN_hogels.exr and .png, testN_directions.exr and .png, and, if
/// there are errors of views, testN_views.exr and .png, testN_ranks.png. Returns the images for the
/// page, scaled down like those of views.
ReportPanel writePanelError(const std::filesystem::path& folder, std::size_t test,
                            const ReportRequest& request, const PanelError& error,
                            const std::vector<double>& viewErrors, const PanelParams& display);

/// Returns the bytes that the page has for the next view after those `before`, in the order of the
/// tests. Most are for the first test, whose pictures should have all pixels; those of the others
/// lead to their files. What these leave is for the others.
std::size_t roomForView(const std::vector<ReportView>& before, std::size_t tests);

/// A view for the page: its row, its test and "worst", "median" or "best".
struct ChosenView {
  std::size_t row = 0;
  std::size_t test = 0;
  std::string which;
};

/// Writes FOLDER/views/testN_WHICH_reference.png, …_test.png, …_difference.png, and
/// testN_WHICH.png, in which they are side by side with the map of their error. Returns them for
/// the page, scaled down to at most `room` bytes.
ReportView writeView(const std::filesystem::path& folder, const ChosenView& view, std::size_t room,
                     const ViewPair& pair, const SheetLabels& labels, const Progress& progress);

}  // namespace hogelscope
