// SPDX-License-Identifier: BSD-3-Clause
// What a store says of itself: the shape of light field and blocks, the display. It stands as JSON
// in the description of the file's first page.
//
// A store is a BigTIFF with one page for each row of blocks of hogels, and one more for the
// overview. A tile is a block of hogels × directions, 64×64 pixels: texel (i, j, u, v) of block
// (I, J, U, V) is at column i·block.u + u, row j·block.v + v of tile column I·blocks.u + U, tile
// row V of page J. What a block has beyond the light field's edges is black.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/light_field/light_field.h"
#include "core/optics/display.h"

namespace hogelscope {

/// A block of hogels × directions; also how many there are along each axis, or its cells.
struct BlockIndex {
  int i = 0;
  int j = 0;
  int u = 0;
  int v = 0;
  bool operator==(const BlockIndex&) const = default;
};

struct StoreHeader {
  LightFieldSize size;
  StoredType type = StoredType::uint8;
  BlockIndex block;                      ///< cells along each axis; i·u and j·v are 64
  LightFieldSize overview;               ///< of the last page
  std::string source;                    ///< what it was made of: by this an unfinished one goes on
  std::optional<DisplayParams> display;  ///< if it was known

  /// How many blocks there are along each axis.
  [[nodiscard]] BlockIndex blocks() const;
};

/// Cells of a block for a light field of this size, where `hogelRows` hogels along j may be in one.
BlockIndex blockFor(const LightFieldSize& size, int hogelRows);

/// The overview's size: at most 64 MB, or an eighth of the whole.
LightFieldSize overviewSize(const LightFieldSize& size, StoredType type);

/// Which hogel or direction of `cells` stands at place k of the overview's `shown`.
constexpr int overviewCell(int k, int shown, int cells) {
  return int((2 * std::int64_t(k) + 1) * cells / (2 * std::int64_t(shown)));
}

std::string textOf(const StoreHeader& header);

/// None where the text is not a store's. Throws InputError where it is one's, but wrong.
std::optional<StoreHeader> parseStoreHeader(const std::string& text);

}  // namespace hogelscope
