// SPDX-License-Identifier: BSD-3-Clause
// Square tiles in one texture, one for each state's image, numbered from the lower left.
#pragma once

#include <cmath>

namespace hogelscope
{

struct Atlas
{
  int Columns = 1; ///< and rows

  static Atlas ForCount(std::size_t count)
  {
    const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
    return { columns > 1 ? columns : 1 };
  }
  int Column(int tile) const { return tile % this->Columns; }
  int Row(int tile) const { return tile / this->Columns; }
};

} // namespace hogelscope
