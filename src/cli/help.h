// SPDX-License-Identifier: BSD-3-Clause
// The text that --help prints.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hogelscope {

/// The help on `topic`: "" for all, or one of helpTopics(). Throws InputError.
std::string helpText(const std::string& topic);

/// "parameters", "man", "completion" and the names of the jobs.
std::vector<std::string_view> helpTopics();

}  // namespace hogelscope
