// SPDX-License-Identifier: BSD-3-Clause
// Where a directional pixel lies in memory: 4-D blocks of neighbouring hogels and directions, since
// neighbouring camera pixels meet both.
#pragma once

#include <array>
#include <cstdint>

#include "core/light_field/slice_layout.h"
#include "core/light_field/texel.h"

namespace hogelscope {

/// One axis' part of an address: blocks of 2^shift cells, blockStride apart; cells cellStride
/// apart. Along i and j of a slice the parts are listed instead.
struct AxisLayout {
  std::uint32_t shift = 0;
  std::uint32_t mask = 0;
  std::uint32_t blockStride = 0;
  std::uint32_t cellStride = 0;
  const std::uint32_t* list = nullptr;

  [[nodiscard]] std::uint32_t operator()(std::uint32_t cell) const {
    return list != nullptr ? list[cell] : inBlocks(cell);
  }
  /// Where there is no list.
  [[nodiscard]] std::uint32_t inBlocks(std::uint32_t cell) const {
    return (cell >> shift) * blockStride + (cell & mask) * cellStride;
  }
};

/// Addresses in texels. The four parts of an address add up, so that a window or an interpolation
/// adds its taps axis by axis.
struct BlockLayout {
  AxisLayout i;
  AxisLayout j;
  AxisLayout u;
  AxisLayout v;
  std::uint32_t texels = 0;  ///< with the padding of incomplete blocks

  BlockLayout() = default;
  /// `blockShifts`: log2 of the block's cells along i, j, u, v; smaller where the axis is shorter.
  /// Throws std::length_error beyond 2^32 - 2 texels.
  BlockLayout(const LightFieldSize& size, const std::array<std::uint32_t, 4>& blockShifts);
  /// Of a slice, which must outlive it.
  explicit BlockLayout(const SliceLayout& slice);

  [[nodiscard]] std::uint32_t address(const TexelIndex& at) const;
};

}  // namespace hogelscope
