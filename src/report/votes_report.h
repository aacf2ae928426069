// SPDX-License-Identifier: BSD-3-Clause
// Viewers' votes: their means beside the metrics of a report (--votes).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/page/votes_page.h"

namespace hogelscope {

/// Reads files of votes, of one page and different viewers, and the tables of the report in
/// `folder`, if it has one. Throws InputError.
VotesReport votesReport(const std::vector<std::string>& files, const std::filesystem::path& folder);

/// Writes votes.csv and votes.html into `folder`. Throws InputError.
void writeVotes(const VotesReport& report, const std::filesystem::path& folder);

}  // namespace hogelscope
