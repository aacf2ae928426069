// SPDX-License-Identifier: BSD-3-Clause
// The manual's table of parameters, generated from their descriptions.
#pragma once

#include <string>

namespace hogelscope {

/// Returns Markdown: the contents of resources/manual/parameters.md, which --help parameters
/// prints.
std::string parameterManual();

}  // namespace hogelscope
