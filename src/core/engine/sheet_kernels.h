// SPDX-License-Identifier: BSD-3-Clause
// The innermost loops over rays through a lens sheet, as those of row_kernels.h.
#pragma once

#include <cstdint>

#include "core/engine/hit_map.h"
#include "core/light_field/block_layout.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// Copies the three sub-pixels that each ray meets, as copyRays().
void copySheetRays(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                   const double* x, const double* y, int count, std::uint8_t* rgb,
                   std::uint8_t* seen);

/// The same for a row's rays at one y, whose x are evenly spread and ascend; rgb and seen are 0
/// before, and stay so beside the panel.
void copySheetRow(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                  const double* x, double y, int count, std::uint8_t* rgb, std::uint8_t* seen);

/// Fills a batch with the cells of one colour, as findCells().
void findSheetCells(const HitMap& map, const double* x, const double* y, int count,
                    std::size_t channel, CellBatch& batch);

}  // namespace hogelscope
