// SPDX-License-Identifier: BSD-3-Clause
// The order of directional pixels in memory: 4-D blocks of neighbouring hogels and directions,
// since neighbouring camera pixels meet both.
#pragma once

#include <array>
#include <cstdint>

#include "core/light_field/slice_layout.h"
#include "core/light_field/texel.h"

namespace hogelscope {

/// One axis' part of an address: blocks of 2^shift cells are blockStride apart, cells cellStride.
/// The parts along i and j of a slice are listed instead.
struct AxisLayout {
  std::uint32_t shift = 0;
  std::uint32_t mask = 0;
  std::uint32_t blockStride = 0;
  std::uint32_t cellStride = 0;
  const std::uint32_t* list = nullptr;

  [[nodiscard]] std::uint32_t operator()(std::uint32_t cell) const {
    return list != nullptr ? list[cell] : inBlocks(cell);
  }
  /// Returns the part where there is no list.
  [[nodiscard]] std::uint32_t inBlocks(std::uint32_t cell) const {
    return (cell >> shift) * blockStride + (cell & mask) * cellStride;
  }
};

/// Addresses, in texels. An address is the sum of four parts, so that a window or an interpolation
/// adds its taps axis by axis.
struct BlockLayout {
  AxisLayout i;
  AxisLayout j;
  AxisLayout u;
  AxisLayout v;
  std::uint32_t texels = 0;  ///< including the padding of incomplete blocks

  BlockLayout() = default;
  /// `blockShifts` is log2 of the block's cells along i, j, u, v; less where the axis is shorter.
  /// Throws std::length_error beyond 2^32 - 2 texels.
  BlockLayout(const LightFieldSize& size, const std::array<std::uint32_t, 4>& blockShifts);
  /// Makes the layout of a slice, which must outlive this object.
  explicit BlockLayout(const SliceLayout& slice);

  [[nodiscard]] std::uint32_t address(const TexelIndex& at) const;
};

}  // namespace hogelscope
