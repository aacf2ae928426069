// SPDX-License-Identifier: BSD-3-Clause
#include "core/light_field/layout_params.h"

namespace hogelscope {

void describe(ParameterVisitor& v, LiveParams& p) {
  auto& [samples, fill, depth] = p;
  v.group("live", "How a 3-D scene becomes directional pixels.");
  v.field("samples", samples, {1, 4096, 1}, "",
          "Rays of a directional pixel, over its hogel's area and its angle; 1: the middle ray.");
  v.field("fill", fill, {0, 1, 0.05}, "",
          "Part of a hogel's side, and of a direction's, over which the rays are spread.");
  v.field("depth", depth, {-1e6, 1e6, 0.01}, "m",
          "Content behind the first and in front of the second depth is left out.");
}

}  // namespace hogelscope
