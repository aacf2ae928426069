// SPDX-License-Identifier: BSD-3-Clause
// The innermost loop over the rays of a lens: cells from polynomials of the lens's ideal points,
// unless a ray is so near a cell's border that only the exact points decide
// (docs/formulas.md, Strips of a lens).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/engine/hit_map.h"
#include "core/engine/ray_strips.h"
#include "core/lens/lens_table.h"
#include "core/light_field/block_layout.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// A HitMap of a design with linear hogel lenses, in whole numbers: indices count units of 2^-shift
/// of a cell.
struct FixedMap {
  /// None if the display has too many cells for it.
  static std::optional<FixedMap> of(const HitMap& map);

  HitMap map;
  std::array<double, 4> constant{};
  std::array<double, 4> slope{};
  std::array<float, 2> perHogel{};  ///< directions that a ray gains for each hogel, across and down
  std::array<double, 4> end{};
  int shift = 0;
  double mostDoubt = 0;  ///< units; beyond, too many strips would have a ray in doubt
};

/// Copies the texels of whole rows as copyRays() does; `strips` are the image's.
void copyLensRays(const FixedMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                  const LensStrips* strips, std::span<const RayRow> rows);

}  // namespace hogelscope
