// SPDX-License-Identifier: BSD-3-Clause
// Reads the tables of a report that was made before.
#pragma once

#include <filesystem>
#include <vector>

#include "core/metrics/summary.h"

namespace hogelscope {

struct StoredReport {
  std::vector<ReportRow> rows;  ///< in ReportOrder; a figure that the files do not have is NaN
  std::vector<TestRate> rates;  ///< of the tests whose rate the summary has
};

/// Reads report.csv and, where they are there, metrics.csv and summary.csv of a folder. Throws
/// InputError if it has no report.
StoredReport readReport(const std::filesystem::path& folder, const MetricSet& metrics);

}  // namespace hogelscope
