// SPDX-License-Identifier: BSD-3-Clause
// A plan in words, for --explain and the window.
#pragma once

#include <string>
#include <vector>

#include "core/engine/plan.h"

namespace hogelscope {

/// One decision of a plan.
struct Decision {
  std::string what;
  std::string why;
  std::string saves;  ///< rays, taps or bytes; "" where it saves nothing
};

/// Returns the decisions of `plan`, which must be the view's.
std::vector<Decision> decisionsOf(const RenderJob& job, const Plan& plan);

/// Describes a plan in one line: "nearest, 1 ray a pixel, 25 of 25 taps, lens table kept".
std::string oneLine(const RenderJob& job, const Plan& plan);

}  // namespace hogelscope
