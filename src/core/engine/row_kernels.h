// SPDX-License-Identifier: BSD-3-Clause
// The innermost loops over rays, which find the cells that rays meet, or copy texels if a pixel is
// one texel. The compiler vectorises these plain loops for AVX-512, AVX2 and the baseline.
#pragma once

#include <cstdint>
#include <span>

#include "core/engine/hit_map.h"
#include "core/engine/ray_strips.h"
#include "core/light_field/block_layout.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// Gives lanes without a hit the cells of one with a hit, so that whole batches stay away from
/// borders. Returns false if there is none.
bool fillUnseen(int count, CellBatch& batch);

/// Copies the texels of rays that are known to hit a design, by a map of linear hogel lenses, from
/// a light field that is all in memory: three bytes each. A coordinate that rounding has put on a
/// border belongs to the last cell.
void copyHits(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
              std::span<const RayRow> rows);

/// Copies the texels of any rays; those that see nothing get the black texel behind all others.
/// Writes 255 or 0 for seen or not.
void copyRays(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
              std::span<const RayRow> rows);

/// Finds the cells of at most a strip of rays that meet a design, by a map of linear hogel lenses.
void findStripCells(const HitMap& map, const double* x, const double* y, int count,
                    CellStrip& strip);

/// Fills a batch with the cells of one colour of a twin, of which others have the same; cell 0
/// where nothing is seen.
void findCells(const HitMap& map, const double* x, const double* y, int count, CellBatch& batch,
               std::size_t channel = greenChannel);

}  // namespace hogelscope
