// SPDX-License-Identifier: BSD-3-Clause
// The states' small images in one texture, a tile for each.
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

  /// Room for so many; all are empty where the number is another one.
  void setCount(std::size_t count);
  /// All are empty.
  void clear();
  /// RGB, stretched to the tile. Does nothing where there is no such tile.
  void setImage(std::size_t index, vtkImageData* image);
  [[nodiscard]] int columns() const { return m_atlas.Columns; }
  [[nodiscard]] vtkTexture* texture() const { return m_texture; }

 private:
  Atlas m_atlas;
  std::size_t m_count = 0;
  int m_tile = 0;  ///< its side in texels
  vtkNew<vtkImageData> m_image;
  vtkNew<vtkTexture> m_texture;
};

}  // namespace hogelscope
