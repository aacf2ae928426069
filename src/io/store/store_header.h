// SPDX-License-Identifier: BSD-3-Clause
// The metadata of a store: the shape of light field and blocks, and the display. It is JSON in the
// description of the file's first page.
//
// A store is a BigTIFF with one page for each row of blocks of hogels, and one more for the
// overview. A tile is a block of hogels × directions, 64×64 pixels: texel (i, j, u, v) of block (I,
// J, U, V) is at column i·block.u + u, row j·block.v + v of tile column I·blocks.u + U, tile row V
// of page J. Cells beyond the light field's edges are black. A page's name is the hash of its
// compressed non-black tiles, followed by the sizes of all tiles, 32 bits each, 0 for black ones;
// it identifies the content without reading the store. A store whose pages have no names is read
// for that.
#pragma once

#include <optional>
#include <string>

#include "core/light_field/light_field.h"
#include "core/panel/display.h"
#include "io/files/content_hash.h"

namespace hogelscope {

/// The index of a block of hogels × directions; also a number of blocks or cells along each axis.
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
  BlockIndex block;         ///< cells along each axis; i·u and j·v are 64
  LightFieldSize overview;  ///< size of the overview, the last page
  std::string source;       ///< identifies the source, so that an unfinished store can be resumed
  std::optional<PanelParams> display;  ///< if known

  /// Returns the number of blocks along each axis.
  [[nodiscard]] BlockIndex blocks() const;
};

/// Returns the cells of a block for a light field of this size, at most `hogelRows` hogels along j.
BlockIndex blockFor(const LightFieldSize& size, int hogelRows);

/// Returns the overview's size: at most 64 MB, or an eighth of the whole.
LightFieldSize overviewSize(const LightFieldSize& size, StoredType type);

/// Returns the hogel or direction, of `cells`, that is at index k of the overview's `shown`.
constexpr int overviewCell(int k, int shown, int cells) {
  return int((2 * std::int64_t(k) + 1) * cells / (2 * std::int64_t(shown)));
}

std::string textOf(const StoreHeader& header);

/// Returns "XXH3-128 " and 32 digits.
std::string pageNameOf(const ContentHash& tiles);
bool isPageName(const std::string& name);

/// Parses a header. Returns none if the text is not a store's. Throws InputError if it is an
/// invalid one.
std::optional<StoreHeader> parseStoreHeader(const std::string& text);

}  // namespace hogelscope
