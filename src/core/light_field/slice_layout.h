// SPDX-License-Identifier: BSD-3-Clause
// Where the directional pixels of a footprint lie in memory: a picture of only those columns and
// rows of the hogel image that a view reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/light_field/footprint.h"

namespace hogelscope {

/// Addresses in texels, modulo 2^32: direction u of a column of hogels is u behind its start,
/// direction v of a row v·width behind its start.
struct SliceLayout {
  /// Neighbouring columns of the hogel image that stay neighbours.
  struct Run {
    int i = 0;
    CellRange u;
  };

  Footprint footprint;
  std::vector<Run> runs;  ///< a row's texels, from its first on
  std::uint32_t width = 0;
  std::vector<std::uint32_t> columnStart;  ///< of each i
  std::vector<std::uint32_t> rowStart;     ///< of each j
  std::uint32_t texels = 0;
};

/// All of it at once. Throws std::length_error beyond 2^32 - 2 texels.
SliceLayout sliceLayout(const Footprint& footprint);

/// For a light field that passes from the top: row of hogels j and those below it are needed until
/// row lastUse[j] has come, then later ones take their places.
SliceLayout rollingLayout(const Footprint& footprint, const std::vector<int>& lastUse);

}  // namespace hogelscope
