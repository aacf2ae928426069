// SPDX-License-Identifier: BSD-3-Clause
// The texts of --help, generated from the tables of jobs and flags and the descriptions of
// parameters.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hogelscope {

/// Returns the help on `topic`: "" for all, or one of helpTopics(). Throws InputError.
std::string helpText(const std::string& topic);

/// Returns "parameters", "man", "completion" and the names of the jobs.
std::vector<std::string_view> helpTopics();

/// Returns hogelscope(1) in man(7), which --help man prints and the build installs.
std::string manPage();

/// Returns Markdown: the contents of resources/manual/parameters.md, which --help parameters
/// prints.
std::string parameterManual();

/// Returns a script of bash, which --help completion prints and the build installs.
std::string bashCompletion();

}  // namespace hogelscope
