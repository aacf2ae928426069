// SPDX-License-Identifier: BSD-3-Clause
// The manual's table of parameters, made from their descriptions.
#pragma once

#include <string>

namespace hogelscope {

/// Markdown: what resources/manual/parameters.md holds and --help parameters prints.
std::string parameterManual();

}  // namespace hogelscope
