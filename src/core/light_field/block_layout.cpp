// SPDX-License-Identifier: BSD-3-Clause
#include "core/light_field/block_layout.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>

namespace hogelscope {

BlockLayout::BlockLayout(const LightFieldSize& size,
                         const std::array<std::uint32_t, 4>& blockShifts) {
  const std::array<std::uint32_t, 4> cells{std::uint32_t(size.nx), std::uint32_t(size.ny),
                                           std::uint32_t(size.du), std::uint32_t(size.dv)};
  const std::array<AxisLayout*, 4> axes{&i, &j, &u, &v};
  // The order from the innermost is i, j, u, v, within a block and among blocks: neighbouring
  // camera pixels meet neighbouring hogels first.
  constexpr std::array<std::size_t, 4> innermostFirst{0, 1, 2, 3};
  std::uint64_t stride = 1;
  for (const std::size_t axis : innermostFirst) {
    const auto needed = std::uint32_t(std::bit_width(cells[axis] - 1));
    axes[axis]->shift = std::min(blockShifts[axis], needed);
    axes[axis]->mask = (1U << axes[axis]->shift) - 1;
    axes[axis]->cellStride = std::uint32_t(stride);
    stride <<= axes[axis]->shift;
  }
  for (const std::size_t axis : innermostFirst) {
    axes[axis]->blockStride = std::uint32_t(stride);
    stride *= (cells[axis] + axes[axis]->mask) >> axes[axis]->shift;
    if (stride >= std::numeric_limits<std::uint32_t>::max())
      throw std::length_error("more than 2^32 directional pixels in memory");
  }
  texels = std::uint32_t(stride);
}

BlockLayout::BlockLayout(const SliceLayout& slice) : texels(slice.texels) {
  i.list = slice.columnStart.data();
  j.list = slice.rowStart.data();
  u.blockStride = 1;
  v.blockStride = slice.width;
}

std::uint32_t BlockLayout::address(const TexelIndex& at) const {
  return i(std::uint32_t(at.i)) + j(std::uint32_t(at.j)) + u(std::uint32_t(at.u)) +
         v(std::uint32_t(at.v));
}

}  // namespace hogelscope
