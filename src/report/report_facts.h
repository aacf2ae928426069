// SPDX-License-Identifier: BSD-3-Clause
// Facts about the inputs of a report for its page, the key that identifies unfinished work, and
// the versions of the program and of its libraries.
#pragma once

#include <string>
#include <vector>

#include "campaign/file_hashes.h"
#include "report/page/report_page.h"
#include "report/report_request.h"

namespace hogelscope {

/// Versions of the program and of the libraries that affect its results, for reports; the About box
/// adds those of the window.
struct Version {
  std::string name;
  std::string version;
};

/// Returns the versions, Hogelscope first.
std::vector<Version> versions();

/// Returns a line such as "Hogelscope 0.2.0, OpenCV 4.6.0, …".
std::string versionsLine();

struct ReportFacts {
  std::vector<ReportFact> lines;
  /// Identical for the same program, states, settings and contents of the light fields.
  std::string key;
};

/// Collects the facts; hashes the light fields' files unless cached. Throws InputError, Cancelled.
ReportFacts factsOf(const ReportRequest& request, FileHashes& hashes, const Progress& progress);

}  // namespace hogelscope
