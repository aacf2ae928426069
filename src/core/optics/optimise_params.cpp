// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/optimise_params.h"

namespace hogelscope {

void describe(ParameterVisitor& v, OptimiseParams& p) {
  auto& [target, views, keep, samples, iterations, tolerance, lift, heldOut, seed] = p;
  static constexpr std::array<std::string_view, 3> targets{"light", "ideal", "views"};
  v.group("optimise", "What should be shown in place of the light field (--optimise).");
  v.field(
      "target", target, targets,
      "What views should look like: \"light\": each directional pixel as the light field's own; "
      "\"ideal\": the ideal views of the states; \"views\": a picture for each state.");
  v.count(target == OptimiseTarget::views);
  v.field("views", views, "Folder of the pictures, STATE.png, in the states' resolutions.");
  v.count(target != OptimiseTarget::light);
  v.field(
      "keep", keep, {0, 1000, 0.01}, "",
      "Weight of each directional pixel's own light, as a part of the mean weight of those that "
      "the states see.");
  v.count(true);
  v.field("samples", samples, {1, 4096, 1}, "",
          "Rays of each directional pixel of a live scene, over all of its hogel and direction.");
  v.field("iterations", iterations, {1, 100000, 1}, "", "Most iterations of a hogel.");
  v.field("tolerance", tolerance, {0, 10, 0.01}, "dB",
          "A hogel is done where ten iterations lower its error by less; 0: never.");
  v.field("lift", lift, {0, 0.99, 0.01}, "",
          "Parts of white by which black is raised and white lowered, so that there is room to "
          "take ghosts away: linear where psf.light is.");
  v.field({"heldOut", "Held-out eyes"}, heldOut, {1, 1000, 1}, "",
          "Eyes between those of the states that judge the result and are not optimised for.");
  v.field("seed", seed, {0, 2147483647, 1}, "", "Of the places of these eyes.");
}

}  // namespace hogelscope
