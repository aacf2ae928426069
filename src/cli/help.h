// SPDX-License-Identifier: BSD-3-Clause
// The text of --help.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hogelscope {

/// Returns the help on `topic`: "" for all, or one of helpTopics(). Throws InputError.
std::string helpText(const std::string& topic);

/// Returns "parameters", "man", "completion" and the names of the jobs.
std::vector<std::string_view> helpTopics();

}  // namespace hogelscope
