// SPDX-License-Identifier: BSD-3-Clause
// Tables and page of a campaign, from the finished reports of its scenes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/campaign.h"
#include "core/metrics/over_scenes.h"

namespace hogelscope {

/// The findings of a campaign.
struct CampaignResult {
  MetricSet metrics;
  std::vector<std::string> scenes;  ///< that have a report, in the campaign's order
  std::vector<std::string> groups;  ///< in the campaign's order
  OverScenes over;
  std::vector<std::string> missing;  ///< "SCENE: WHAT is missing …"
  std::vector<std::string> columns;  ///< of the table of means (tableColumns())
};

/// Returns the columns of a campaign's table of means: those that it names, else "scenes" and the
/// headlines. Throws InputError if the metrics have no such mean.
std::vector<std::string> tableColumns(const Campaign& campaign, const MetricSet& metrics);

/// Returns the metrics of all scenes. Throws InputError if they have different ones, or only some
/// have frames.
MetricSet campaignMetrics(const Campaign& campaign, const std::filesystem::path& output);

/// Returns the files that writeCampaign() writes.
std::vector<std::filesystem::path> campaignFiles(const std::filesystem::path& output);

/// Reads the scenes' reports in `output` and writes there campaign.csv, summary.csv, bd.csv,
/// plots/ and campaign.html. Throws InputError if a scene that has tests has no report.
CampaignResult writeCampaign(const Campaign& campaign, const std::filesystem::path& output);

/// Returns the results for a terminal, one line each.
std::string campaignText(const CampaignResult& result);

}  // namespace hogelscope
