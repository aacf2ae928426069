// SPDX-License-Identifier: BSD-3-Clause
// The page of a campaign.
#pragma once

#include "campaign/campaign_tables.h"

namespace hogelscope {

/// Writes campaign.html, plots/campaign.tex and, where groups are compared, plots/bd_rates.svg and
/// .csv. Throws InputError.
void writeCampaignPage(const CampaignResult& result, const std::string& title,
                       const std::filesystem::path& output);

}  // namespace hogelscope
