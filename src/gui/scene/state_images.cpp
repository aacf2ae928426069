// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/state_images.h"

#include <vtkImageData.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cstdint>

namespace hogelscope {

namespace {
constexpr int longestTile = 192;   ///< texels: few states have fine images
constexpr int longestSide = 1024;  ///< of the texture, which is uploaded again with each image
constexpr std::uint8_t emptyGrey = 40;
}  // namespace

StateImages::StateImages() {
  m_texture->SetInputData(m_image);
  m_texture->InterpolateOn();
  setCount(1);
}

StateImages::~StateImages() = default;

void StateImages::setCount(std::size_t count) {
  if (count == m_count) return;
  m_count = count;
  m_atlas = Atlas::ForCount(count);
  m_tile = std::clamp(longestSide / m_atlas.Columns, 1, longestTile);
  const int side = m_tile * m_atlas.Columns;
  m_image->SetDimensions(side, side, 1);
  m_image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  clear();
}

void StateImages::clear() {
  std::fill_n(static_cast<std::uint8_t*>(m_image->GetScalarPointer()),
              3 * m_image->GetNumberOfPoints(), emptyGrey);
  m_image->Modified();
  m_texture->Modified();  // marks actors with this texture as changed
}

void StateImages::setImage(std::size_t index, vtkImageData* image) {
  if (index >= m_count) return;
  const int* size = image->GetDimensions();
  const int left = m_atlas.Column(int(index)) * m_tile;
  const int bottom = m_atlas.Row(int(index)) * m_tile;
  for (int y = 0; y < m_tile; ++y) {
    auto* to = static_cast<std::uint8_t*>(m_image->GetScalarPointer(left, bottom + y, 0));
    for (int x = 0; x < m_tile; ++x, to += 3)
      std::copy_n(static_cast<const std::uint8_t*>(
                      image->GetScalarPointer(x * size[0] / m_tile, y * size[1] / m_tile, 0)),
                  3, to);
  }
  m_image->Modified();
  m_texture->Modified();
}

}  // namespace hogelscope
