// SPDX-License-Identifier: BSD-3-Clause
#include "core/content/pattern.h"

namespace hogelscope {

void describe(ParameterVisitor& v, PatternParams& p) {
  auto& [depth, period, angle] = p;
  v.group("pattern", "Test content in closed form; no part of a session document.");
  v.field("depth", depth, {-10, 10, 0.01}, "m",
          "checkerboard, edge: distance of their plane in front of the panel; behind it below 0.");
  v.field("period", period, {1e-6, 10, 0.01}, "m",
          "checkerboard: side of two squares; spheres: of two squares of their planes.");
  v.field("angle", angle, {-89, 89, 1}, "°", "edge: its turn from the vertical, to the left.");
}

}  // namespace hogelscope
