// SPDX-License-Identifier: BSD-3-Clause
// Finds the frames of a light field in time, each in a folder that its number names.
#pragma once

#include <optional>
#include <string>

#include "core/base/progress.h"
#include "io/opening/light_field_order.h"

namespace hogelscope {

struct FoundFrames {
  std::string file;  ///< FOLDER/NAME with {T} for the number
  Sureness sureness = Sureness::unknown;
};

/// Returns the frames in a folder whose folders all are named by a number, and each of which has
/// the same grid of views, by row and column. Sure, or likely, is what the pictures say: those of
/// one view in the first two folders are alike; if they are not, they are several scenes. None for
/// anything else. Throws Cancelled.
std::optional<FoundFrames> framesInFolder(const std::string& folder, const Progress& progress);

}  // namespace hogelscope
