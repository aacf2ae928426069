// SPDX-License-Identifier: BSD-3-Clause
// The testing procedure (the paper's section V): every camera state rendered from the session's
// light field and from each test light field, and compared; states side by side. Goes on where an
// earlier run of the same request stopped.
#pragma once

#include <string>
#include <vector>

#include "report/report_request.h"

namespace hogelscope {

/// Opens every one, so that a bad one is told before the work. Throws InputError.
std::vector<ReportTest> openTests(const Session& session, const std::vector<std::string>& files);

/// Writes report.csv, metrics.csv, summary.csv, bd.csv, report.html, panel_error/, and with
/// `images` the images. A state that cannot be rendered is a row that says why. Throws
/// InputError, or Cancelled: then what is finished is on disk. Of a shard only the rows of its
/// states are made; the run without a shard takes up those of all shards, and makes what is
/// missing.
Report makeReport(const ReportRequest& request, const ReportListener& listener);

}  // namespace hogelscope
