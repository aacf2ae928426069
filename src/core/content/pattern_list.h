// SPDX-License-Identifier: BSD-3-Clause
// The list of patterns by name.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/content/pattern.h"

namespace hogelscope {

struct NamedPattern {
  std::string_view name;
  std::string_view help;  ///< a description of the content
  std::unique_ptr<Pattern> (*make)(const PanelParams& display, const PatternParams& params);
};

const std::vector<NamedPattern>& patterns();

/// Makes a pattern. Throws InputError for an unknown name, or a display without hogels or
/// directions.
std::unique_ptr<Pattern> makePattern(const std::string& name, const PanelParams& display,
                                     const PatternParams& params);

}  // namespace hogelscope
