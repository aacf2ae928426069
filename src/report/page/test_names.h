// SPDX-License-Identifier: BSD-3-Clause
// Short names of tests, which a report knows by their files' paths.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

/// Returns the files' names, with as much of their paths as makes them differ.
std::vector<std::string> shortNames(const std::vector<std::string>& files);

/// Returns the names for figures: the files' names without their endings if these differ, else
/// shortNames().
std::vector<std::string> figureNames(const std::vector<std::string>& files);

/// Returns the beginning of the names of a test's plots, such as "test3_hevc_q22": its number, from
/// 1, and its name with "_" for all that is not of ASCII letters, digits, "-" and ".". `test`
/// counts from 0.
std::string plotNameOf(const std::string& file, std::size_t test);

}  // namespace hogelscope
