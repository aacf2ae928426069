// SPDX-License-Identifier: BSD-3-Clause
// The testing procedure (the paper's section V): renders and compares every camera state from the
// session's light field and from each test light field, states in parallel. Resumes an earlier run
// of the same request. report.csv keeps its columns (later figures are in metrics.csv) and is
// written last. Headlines are over the pixels seen in both images; tolerances are left aside. Plots
// are Figures, made once for the page and for `plots`. A function of Python finds its columns by
// the first views that see anything, before the report begins; the folder keeps them until it is
// finished.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/report_request.h"

namespace hogelscope {

/// Opens all tests before rendering. Throws InputError.
std::vector<ReportTest> openTests(const Session& session, const std::vector<std::string>& files);

/// Returns all files that a report reads, with what its light fields are made of.
std::vector<std::filesystem::path> inputsOf(const ReportRequest& request);

/// Returns the bits of the files with pixels per directional pixel and frame; other files of a
/// folder do not count. None if the light field has no files.
std::optional<double> rateOfFiles(const ReportTest& test);

/// Writes report.csv, metrics.csv, summary.csv, bd.csv, report.html, panel_error/, and with
/// `images` the images. A state that cannot be rendered gives a row with a problem. Throws
/// InputError or Cancelled; finished rows are then on disk. With a shard, only the rows of its
/// states are computed; the run without a shard takes those of all shards and computes the missing
/// ones.
Report makeReport(const ReportRequest& request, const ReportListener& listener);

}  // namespace hogelscope
