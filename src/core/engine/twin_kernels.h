// SPDX-License-Identifier: BSD-3-Clause
// The innermost loops over rays of a twin, as those of row_kernels.h.
#pragma once

#include <array>
#include <cstdint>

#include "core/engine/hit_map.h"
#include "core/light_field/block_layout.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// Copies the texels of any rays of a twin of which Twin::hasKernel() is true, as copyRays().
void copyTwinRays(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                  const double* x, const double* y, int count, std::uint8_t* rgb,
                  std::uint8_t* seen);

/// The same for the rays of a row of an affine twin, of columns [parts[0], parts[3]), of which
/// [parts[1], parts[2]) are known to hit; x, rgb and seen begin at parts[0].
void copyTwinRow(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                 const double* x, double y, const std::array<int, 4>& parts, std::uint8_t* rgb,
                 std::uint8_t* seen);

/// Fills a batch with the cells of one colour of any twin, as findCells().
void findTwinCells(const HitMap& map, const double* x, const double* y, int count,
                   std::size_t channel, CellBatch& batch);

}  // namespace hogelscope
