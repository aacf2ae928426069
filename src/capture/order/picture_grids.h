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

/// Hogels with clear borders, which are not those of the blocks of a JPEG, even if it was decoded
/// and scaled. Neighbouring pixels differ there more than elsewhere, because one hogel ends with
/// its last direction and the next begins with its first.
struct HogelGrid {
  std::array<int, 2> hogels{};      ///< across, down
  std::array<int, 2> directions{};  ///< across, down
  double standOut = 0;  ///< of the borders' differences, standard errors; the lesser of both axes
  /// Neighbouring hogels resemble each other more than the ends of one of them, along one axis at
  /// least, which no continuous picture shows, whatever borders a codec gives it.
  bool isDistinct = false;
  /// There is little evidence but the borders, which content with lines, blocks of a scaled JPEG
  /// and enlarged pixels have too.
  bool isVague = false;
};

/// Tiles that show one scene: along both axes the image is more similar to itself about one tile
/// further than a quarter of a tile less or more.
struct TileGrid {
  std::array<int, 2> tiles{};  ///< across, down; at most 32 of at least 24 pixels each
  double likeness = 0;         ///< 0 … 1, the lesser of both axes; 1: the tiles are equal
};

struct PictureGrids {
  std::optional<HogelGrid> hogels;
  std::optional<TileGrid> tiles;
};

/// Finds both grids, each where it stands out along both axes (docs/formulas.md, Order of views).
/// Content with a grid of its own in the panel's plane can be mistaken for hogels, and content that
/// repeats for tiles. `read` may be called twice. Throws what it throws,
/// Cancelled.
PictureGrids findPictureGrids(const PictureRows& picture, const Progress& progress);

}  // namespace hogelscope
