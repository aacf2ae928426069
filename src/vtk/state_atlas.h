// SPDX-License-Identifier: BSD-3-Clause
// The small images of the states in one texture.
#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTexture.h>

#include "atlas.h"

namespace hogelscope
{

/// The small images of the states in one texture, with one tile each.
class StateAtlas
{
public:
  StateAtlas();

  /// Sets the number of tiles. If it changes, all tiles become empty.
  void SetCount(std::size_t count);
  /// Empties all tiles.
  void Clear();
  /// Sets an RGB image, stretched to the tile. Ignores an index without a tile.
  void SetImage(std::size_t index, vtkImageData* image);
  [[nodiscard]] int GetColumns() const { return this->Tiles.Columns; }
  [[nodiscard]] vtkTexture* GetTexture() const { return this->Texture; }

private:
  Atlas Tiles;
  std::size_t Count = 0;
  int Side = 0; ///< side length in texels
  vtkNew<vtkImageData> Image;
  vtkNew<vtkTexture> Texture;
};

} // namespace hogelscope
