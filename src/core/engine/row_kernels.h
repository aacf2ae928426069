// SPDX-License-Identifier: BSD-3-Clause
// The innermost loops over rays, which find the cells that rays meet, or copy texels if a pixel is
// one texel or three sub-pixels, by the finder of their map.
#pragma once

#include <cstdint>
#include <span>

#include "core/engine/hit_map.h"
#include "core/engine/ray_strips.h"
#include "core/light_field/block_layout.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// Returns the finder of a display's rays.
Finder finderOf(const Display& display);

/// Gives lanes without a hit the cells of one with a hit, so that whole batches stay away from
/// borders. Returns false if there is none.
bool fillUnseen(int count, CellBatch& batch);

/// Copies the texels of rays from a light field that is all in memory: three bytes each, 0 where
/// nothing is seen. `isPlain`: each row has one y, and all its rays are known to hit a design with
/// linear hogel lenses.
void copyRays(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
              bool isPlain, std::span<const RayRow> rows);

/// Fills a batch with the cells of one colour, of which others have the same unless the display
/// splits them; cell 0 where nothing is seen.
void findCells(const HitMap& map, const double* x, const double* y, int count, CellBatch& batch,
               std::size_t channel = greenChannel);

}  // namespace hogelscope
