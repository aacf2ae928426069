// SPDX-License-Identifier: BSD-3-Clause
// Finds the frames of a light field in time, each in a folder or a file that its number names.
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
/// the same grid of views, by row and column: sure, or likely, by how alike the pictures of one
/// view in the first two are. Or in a folder whose files are numbered quilts, by their names, of
/// which the first two are alike: likely, because names and pictures of codings of one frame are
/// so, too. None for anything else, such as several scenes. Throws Cancelled.
std::optional<FoundFrames> framesInFolder(const std::string& folder, const Progress& progress);

/// Returns a sentence on the pictures beside a light field of one picture that have its name but
/// for a number, if the next of them is like it: they may be its frames, but also one frame at
/// several rates. Empty if there are none. Throws Cancelled.
std::string framesBeside(const std::string& file, const Progress& progress);

}  // namespace hogelscope
