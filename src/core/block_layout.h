// SPDX-License-Identifier: BSD-3-Clause
// Where a directional pixel lies in memory: 4-D blocks of neighbouring hogels and directions, since
// neighbouring camera pixels meet both.
#pragma once

#include <array>
#include <cstdint>

namespace hogelscope {

struct LightFieldSize;
struct TexelIndex;

/// One axis' part of an address: blocks of 2^shift cells, blockStride apart; cells cellStride
/// apart.
struct AxisLayout {
  std::uint32_t shift = 0;
  std::uint32_t mask = 0;
  std::uint32_t blockStride = 0;
  std::uint32_t cellStride = 0;

  [[nodiscard]] std::uint32_t operator()(std::uint32_t cell) const {
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

  [[nodiscard]] std::uint32_t address(const TexelIndex& at) const;
};

}  // namespace hogelscope
