// SPDX-License-Identifier: BSD-3-Clause
// Facts about a report's inputs for its page, and the key that identifies unfinished work.
#pragma once

#include "report/page/report_page.h"
#include "report/report_request.h"
#include "runs/file_hashes.h"

namespace hogelscope {

struct ReportFacts {
  std::vector<ReportFact> lines;
  /// Identical for the same program, states, settings and contents of the light fields.
  std::string key;
};

/// Returns a file's name as the report has it (ReportRequest::hasRelativeNames).
std::string nameIn(const ReportRequest& request, const std::string& file);

/// Collects the facts; hashes the light fields' files unless cached. Throws InputError, Cancelled.
ReportFacts factsOf(const ReportRequest& request, FileHashes& hashes, const Progress& progress);

/// Returns sentences about inputs that make the figures doubtful: a reference that has lost
/// something itself, as JPEG or a video; a test whose views are in another order (orderTests()).
std::vector<std::string> warningsOf(const ReportRequest& request);

}  // namespace hogelscope
