// SPDX-License-Identifier: BSD-3-Clause
// The states' small pictures in one texture.
#include "gui/scene/state_pictures.h"

#include <vtkImageData.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cstdint>

namespace hogelscope {

namespace {
constexpr int longestTile = 192;   ///< texels: few states have fine pictures
constexpr int longestSide = 1024;  ///< of the whole texture: it is sent anew with each picture
constexpr std::uint8_t emptyGrey = 40;
}  // namespace

StatePictures::StatePictures() {
  m_texture->SetInputData(m_image);
  m_texture->InterpolateOn();
  setCount(1);
}

StatePictures::~StatePictures() = default;

void StatePictures::setCount(std::size_t count) {
  if (count == m_count) return;
  m_count = count;
  m_atlas = Atlas::ForCount(count);
  m_tile = std::clamp(longestSide / m_atlas.Columns, 1, longestTile);
  const int side = m_tile * m_atlas.Columns;
  m_image->SetDimensions(side, side, 1);
  m_image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  clear();
}

void StatePictures::clear() {
  std::fill_n(static_cast<std::uint8_t*>(m_image->GetScalarPointer()),
              3 * m_image->GetNumberOfPoints(), emptyGrey);
  m_image->Modified();
}

void StatePictures::put(std::size_t index, vtkImageData* picture) {
  if (index >= m_count) return;
  const int* size = picture->GetDimensions();
  const int left = m_atlas.Column(int(index)) * m_tile;
  const int bottom = m_atlas.Row(int(index)) * m_tile;
  for (int y = 0; y < m_tile; ++y) {
    auto* to = static_cast<std::uint8_t*>(m_image->GetScalarPointer(left, bottom + y, 0));
    for (int x = 0; x < m_tile; ++x, to += 3)
      std::copy_n(static_cast<const std::uint8_t*>(
                      picture->GetScalarPointer(x * size[0] / m_tile, y * size[1] / m_tile, 0)),
                  3, to);
  }
  m_image->Modified();
}

}  // namespace hogelscope
