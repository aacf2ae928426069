// SPDX-License-Identifier: BSD-3-Clause
// Finds a folder's views and reads their row and column from the file names.
#pragma once

#include <array>

#include "capture/names/view_grid.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// Finds the views. `directions` (columns, rows; 0 = not known) say how one running number counts.
/// Without a pattern the known ones are tried, then the largest series of pictures whose names
/// agree in all but their numbers. Where no name fits but there is a folder 0, that of a JPEG Pleno
/// light field's first components, it is looked at. Throws InputError: no folder, no match, half of
/// the views or more are missing.
ViewFiles findViews(const LightFieldParams& params, std::array<int, 2> directions);

}  // namespace hogelscope
