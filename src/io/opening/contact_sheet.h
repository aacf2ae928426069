// SPDX-License-Identifier: BSD-3-Clause
// A picture of a light field's views as they are put on the display, with arrows.
#pragma once

#include <filesystem>

#include "core/optics/display.h"
#include "core/optics/image.h"
#include "io/opening/order_document.h"

namespace hogelscope {

/// Draws up to 5×5 views where their cameras stand: the left column was taken from the left, the
/// top row from the top, as `assumed` has it. Arrows in the view in the middle show how its content
/// moves to the view on the right (yellow) and to the one below (blue). Where the order is not
/// known, words say what to look for. Throws InputError, or Cancelled.
Image contactSheet(const LightFieldOrder& order, const AssumedOrder& assumed,
                   const DisplayParams& display, const Progress& progress = {});
/// Writes it.
void writeContactSheet(const std::filesystem::path& file, const LightFieldOrder& order,
                       const AssumedOrder& assumed, const DisplayParams& display,
                       const Progress& progress = {});

}  // namespace hogelscope
