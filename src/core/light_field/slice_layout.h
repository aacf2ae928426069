// SPDX-License-Identifier: BSD-3-Clause
// The layout of a footprint's directional pixels in memory: an image of only those columns and rows
// of the hogel image that a view reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/light_field/footprint.h"

namespace hogelscope {

/// Addresses, in texels, modulo 2^32: direction u of a column of hogels is u after its start,
/// direction v of a row is v·width after its start.
struct SliceLayout {
  /// Neighbouring columns of the hogel image that are neighbours here too.
  struct Run {
    int i = 0;
    CellRange u;
  };

  Footprint footprint;
  std::vector<Run> runs;  ///< the texels of a row, in order
  std::uint32_t width = 0;
  std::vector<std::uint32_t> columnStart;  ///< for each i
  std::vector<std::uint32_t> rowStart;     ///< for each j
  std::uint32_t texels = 0;
};

/// Throws InputError if the texels of a view take more than `memory` bytes.
void requireMemory(const Footprint& footprint, std::size_t bytesOfTexel, std::size_t memory);

/// Lays out the whole footprint at once. Throws std::length_error beyond 2^32 - 2 texels.
SliceLayout sliceLayout(const Footprint& footprint);

/// Lays out a light field that is streamed from the top: row j of hogels and those below it are
/// kept until row lastUse[j] has been read; later rows then take their place.
SliceLayout rollingLayout(const Footprint& footprint, const std::vector<int>& lastUse);

}  // namespace hogelscope
