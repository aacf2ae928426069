// SPDX-License-Identifier: BSD-3-Clause
// How many hogels, or views as tiles, a picture has, by what it shows.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

#include "core/base/progress.h"

namespace hogelscope {

/// A picture that is read once, from the top; `read` calls `row` with three values per pixel.
struct PictureRows {
  std::size_t width = 0;
  std::size_t height = 0;
  using Row = std::function<void(std::size_t y, const float* rgb)>;
  std::function<void(const Row& row, const Progress& progress)> read;
};

struct HogelGrid {
  std::array<int, 2> hogels{};      ///< across, down
  std::array<int, 2> directions{};  ///< across, down
  double standOut = 0;  ///< of the borders' differences, standard errors; of the lesser axis
};

/// Reads the picture: at the borders of hogels neighbouring pixels differ more than within, since
/// the one hogel ends with its last direction where the next begins with its first. None where no
/// grid stands out along both axes. Content that has a grid of its own on the panel's plane can be
/// taken for hogels. Throws what `read` throws.
std::optional<HogelGrid> findHogelGrid(const PictureRows& picture, const Progress& progress);

/// Reads the picture: views of one scene lie where it is much more like itself one tile further
/// than a bit less or more. Returns the tiles across and down, at most 20 of at least 100 pixels
/// each; none where no such grid stands out along both axes, or beyond 300 million pixels. Throws
/// what `read` throws, Cancelled.
std::optional<std::array<int, 2>> findTileGrid(const PictureRows& picture,
                                               const Progress& progress);

}  // namespace hogelscope
