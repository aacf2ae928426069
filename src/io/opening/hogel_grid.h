// SPDX-License-Identifier: BSD-3-Clause
// How many hogels of how many directions a hogel image has, by what it shows.
#pragma once

#include <array>
#include <optional>

#include "io/images/image_file.h"

namespace hogelscope {

struct HogelGrid {
  std::array<int, 2> hogels{};      ///< across, down
  std::array<int, 2> directions{};  ///< across, down
  double standOut = 0;  ///< of the borders' differences, standard errors; of the lesser axis
};

/// Reads the picture: at the borders of hogels neighbouring pixels differ more than within, since
/// the one hogel ends with its last direction where the next begins with its first. None where no
/// grid stands out along both axes. Content that has a grid of its own on the panel's plane can be
/// taken for hogels. Throws InputError, Cancelled.
std::optional<HogelGrid> findHogelGrid(ImageFile& image, const Progress& progress);

}  // namespace hogelscope
