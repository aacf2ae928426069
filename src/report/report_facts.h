// SPDX-License-Identifier: BSD-3-Clause
// What was tested, for the report's page; and the key by which a run knows its own unfinished work.
#pragma once

#include "campaign/file_hashes.h"
#include "report/page/report_page.h"
#include "report/report_request.h"

namespace hogelscope {

struct ReportFacts {
  std::vector<ReportFact> lines;
  /// The same for the same program, states, settings and contents of the light fields.
  std::string key;
};

/// Reads the light fields' files whose hashes are not known yet. Throws InputError, Cancelled.
ReportFacts factsOf(const ReportRequest& request, FileHashes& hashes, const Progress& progress);

}  // namespace hogelscope
