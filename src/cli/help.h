// SPDX-License-Identifier: BSD-3-Clause
// The text that --help prints.
#pragma once

#include <string>

namespace hogelscope {

/// The help on `topic`: "" for all, "parameters" or a job's name. Throws InputError.
std::string helpText(const std::string& topic);

}  // namespace hogelscope
