// SPDX-License-Identifier: BSD-3-Clause
// Finds the number of hogels, or of views as tiles, in an image by its content.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

#include "core/base/progress.h"

namespace hogelscope {

/// An image that is read from the top; `read` calls `row` with three values per pixel.
struct PictureRows {
  std::size_t width = 0;
  std::size_t height = 0;
  using Row = std::function<void(std::size_t y, const float* rgb)>;
  std::function<void(const Row& row, const Progress& progress)> read;
};

struct HogelGrid {
  std::array<int, 2> hogels{};      ///< across, down
  std::array<int, 2> directions{};  ///< across, down
  double standOut = 0;  ///< of the borders' differences, standard errors; the lesser of both axes
};

/// Finds the borders of hogels, where neighbouring pixels differ more than elsewhere, because one
/// hogel ends with its last direction and the next begins with its first. None if no grid stands
/// out along both axes. Content with a grid of its own in the panel's plane can be mistaken for
/// hogels. Throws what `read` throws.
std::optional<HogelGrid> findHogelGrid(const PictureRows& picture, const Progress& progress);

/// Finds the tiles, which show one scene: the image is much more similar to itself one tile further
/// than slightly less or more. Returns the tiles across and down, at most 20 of at least 100 pixels
/// each; none if no such grid stands out along both axes, or beyond 300 million pixels. Throws what
/// `read` throws, Cancelled.
std::optional<std::array<int, 2>> findTileGrid(const PictureRows& picture,
                                               const Progress& progress);

}  // namespace hogelscope
