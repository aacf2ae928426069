// SPDX-License-Identifier: BSD-3-Clause
#include "state_atlas.h"

#include <algorithm>
#include <cstdint>

namespace hogelscope
{

namespace
{
constexpr int longestTile = 192;  ///< texels: few states have fine images
constexpr int longestSide = 1024; ///< of the texture, which is uploaded again with each image
constexpr std::uint8_t emptyGrey = 40;
}

StateAtlas::StateAtlas()
{
  this->Texture->SetInputData(this->Image);
  this->Texture->InterpolateOn();
  SetCount(1);
}

void StateAtlas::SetCount(std::size_t count)
{
  if (count == this->Count)
  {
    return;
  }
  this->Count = count;
  this->Tiles = Atlas::ForCount(count);
  this->Side = std::clamp(longestSide / this->Tiles.Columns, 1, longestTile);
  const int side = this->Side * this->Tiles.Columns;
  this->Image->SetDimensions(side, side, 1);
  this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  Clear();
}

void StateAtlas::Clear()
{
  std::fill_n(static_cast<std::uint8_t*>(this->Image->GetScalarPointer()),
    3 * this->Image->GetNumberOfPoints(), emptyGrey);
  this->Image->Modified();
  this->Texture->Modified(); // marks actors with this texture as changed
}

void StateAtlas::SetImage(std::size_t index, vtkImageData* image)
{
  if (index >= this->Count)
  {
    return;
  }
  const int* size = image->GetDimensions();
  const int left = this->Tiles.Column(int(index)) * this->Side;
  const int bottom = this->Tiles.Row(int(index)) * this->Side;
  for (int y = 0; y < this->Side; ++y)
  {
    auto* to = static_cast<std::uint8_t*>(this->Image->GetScalarPointer(left, bottom + y, 0));
    for (int x = 0; x < this->Side; ++x, to += 3)
    {
      std::copy_n(static_cast<const std::uint8_t*>(
                    image->GetScalarPointer(x * size[0] / this->Side, y * size[1] / this->Side, 0)),
        3, to);
    }
  }
  this->Image->Modified();
  this->Texture->Modified();
}

} // namespace hogelscope
