// SPDX-License-Identifier: BSD-3-Clause
// --report --campaign: a report for each scene of a campaign, then the figures over the scenes.
#pragma once

#include "cli/command_line.h"
#include "report/report_request.h"

namespace hogelscope {

/// A report whose light fields are open.
struct OpenReport {
  CommandLine line;
  Session session;
  ReportRequest request;
};

/// Opens what the command line of a report names. Throws InputError.
OpenReport openReport(const CommandLine& line);
/// Makes the report and prints its results. Returns the exit status. Throws InputError, Cancelled.
int makeReport(OpenReport& open);

/// Makes the reports of --campaign and writes the figures over them; with --dry-run prints what
/// would be done. Scenes that an earlier run of the same campaign has finished are taken. Returns
/// the exit status. Throws InputError, Cancelled.
int runCampaign(const CommandLine& line);

}  // namespace hogelscope
