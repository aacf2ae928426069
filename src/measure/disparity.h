// SPDX-License-Identifier: BSD-3-Clause
// The depths of content that is known by its views alone, from the shift of what they show.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/light_field/light_field_source.h"
#include "core/panel/display.h"

namespace hogelscope {

/// The depths that one direction shows through every hogel, row by row: metres in the display
/// frame, NaN where the views have nothing that stands out.
struct HogelDepths {
  int width = 0;
  int height = 0;  ///< hogels, or fewer: each is the mean of a square of `scale` hogels
  int scale = 1;
  std::vector<double> z;

  [[nodiscard]] double at(int i, int j) const {
    const int x = i / scale < width ? i / scale : width - 1;
    const int y = j / scale < height ? j / scale : height - 1;
    return z[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

/// Returns the shift of a point at the depth z from one view to the next, in hogels across and
/// down, as the stored views have it: −s z/p, with the viewing distance D: −s z D/(p (D − z))
/// (docs/formulas.md, Depth budget). s is the slope step of the direction (u, v).
std::array<double, 2> disparityOf(double z, const PanelParams& display,
                                  const std::array<int, 2>& direction);

/// Finds the depths that the direction (u, v) shows, by a plane sweep: the two directions to each
/// side of it, in its row and its column, are shifted as a plane at each of many depths would be,
/// and the depth is that at which they are most alike. What leaves one of the views is not known.
/// Throws InputError (one direction only; or as LightFieldSource::slice()), Cancelled.
HogelDepths depthsByDisparity(const LightFieldSource& lightField, const PanelParams& display,
                              const std::array<int, 2>& direction, const Progress& progress);

}  // namespace hogelscope
