// SPDX-License-Identifier: BSD-3-Clause
// Which channels of an OpenEXR file are its picture. A layer is what precedes the last dot of a
// channel's name, behind the name of the part where there are several.
#pragma once

#include "io/images/codecs.h"

namespace hogelscope {

struct ChosenLayer {
  std::size_t part = 0;
  std::array<int, 3> channels{0, 1, 2};  ///< red, green and blue of the part's channels
  bool isDefault = true;  ///< the first part's first channels, as files without layers have them
  std::string note;       ///< which layers are left aside; "" for none
  std::string refusal;    ///< why no layer can be chosen; "" if one is
};

/// Chooses, in this order: R, G, B of a file without parts and without a layer; the first layer or
/// part whose name has a word for a renderer's whole picture (Combined, beauty, rgba, …); the only
/// one with R, G, B; of parts that are only numbered the first; without colours the first with Y,
/// or the only one. Of two views, the left one.
ChosenLayer chosenLayer(const std::vector<PicturePart>& parts);

}  // namespace hogelscope
