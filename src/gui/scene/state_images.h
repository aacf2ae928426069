// SPDX-License-Identifier: BSD-3-Clause
// The small images of the states in one texture, with one tile each.
#pragma once

#include <vtkNew.h>

#include <cstddef>

#include "vtk/atlas.h"

class vtkImageData;
class vtkTexture;

namespace hogelscope {

class StateImages {
 public:
  StateImages();
  ~StateImages();
  StateImages(const StateImages&) = delete;
  StateImages& operator=(const StateImages&) = delete;

  /// Sets the number of tiles. If it changes, all tiles become empty.
  void setCount(std::size_t count);
  /// Empties all tiles.
  void clear();
  /// Sets an RGB image, stretched to the tile. Ignores an index without a tile.
  void setImage(std::size_t index, vtkImageData* image);
  [[nodiscard]] int columns() const { return m_atlas.Columns; }
  [[nodiscard]] vtkTexture* texture() const { return m_texture; }

 private:
  Atlas m_atlas;
  std::size_t m_count = 0;
  int m_tile = 0;  ///< side length in texels
  vtkNew<vtkImageData> m_image;
  vtkNew<vtkTexture> m_texture;
};

}  // namespace hogelscope
