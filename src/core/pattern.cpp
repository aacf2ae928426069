// SPDX-License-Identifier: BSD-3-Clause
// The patterns by their names.
#include "core/pattern.h"

#include <algorithm>

#include "core/error.h"
#include "core/plane_patterns.h"
#include "core/scene_pattern.h"
#include "core/sphere_pattern.h"

namespace hogelscope {

void describe(ParameterVisitor& v, PatternParams& p) {
  auto& [depth, period, angle] = p;
  v.group("pattern", "What --generate makes; for --set only.");
  v.field("depth", depth, {-10, 10, 0.01}, "m",
          "checkerboard, edge: distance of their plane in front of the panel; behind it below 0.");
  v.field("period", period, {1e-6, 10, 0.01}, "m",
          "checkerboard: side of two squares; spheres: of two squares of their planes.");
  v.field("angle", angle, {-89, 89, 1}, "°", "edge: its turn from the vertical, to the left.");
}

const std::vector<PatternName>& patternNames() {
  static const std::vector<PatternName> names{
      {"scene", "lettering, ruler, ball and wall at known depths, smoothed"},
      {"spheres", "textured spheres and planes before and behind the panel; quick at any size"},
      {"directions", "each pixel's colour tells its direction u, v"},
      {"hogels", "each pixel's colour tells its hogel i, j"},
      {"checkerboard", "black and white squares on a plane at pattern.depth"},
      {"edge", "a slanted edge on a plane at pattern.depth"},
      {"crosstalk", "light to the viewer's left is red, to the right blue"}};
  return names;
}

std::unique_ptr<Pattern> makePattern(const std::string& name, const DisplayParams& display,
                                     const PatternParams& params) {
  if (display.hogels[0] < 1 || display.directions[0] < 1)
    throw InputError("display.hogels", "and directions are needed to make content");
  if (name == "scene") return std::make_unique<ScenePattern>(display);
  if (name == "spheres") return std::make_unique<SpherePattern>(display, params);
  if (name == "directions") return std::make_unique<CodePattern>(display, CodePattern::directions);
  if (name == "hogels") return std::make_unique<CodePattern>(display, CodePattern::hogels);
  if (name == "crosstalk") return std::make_unique<CodePattern>(display, CodePattern::sides);
  if (name == "checkerboard")
    return std::make_unique<PlanePattern>(display, params, PlanePattern::checkerboard);
  if (name == "edge") return std::make_unique<PlanePattern>(display, params, PlanePattern::edge);
  std::string known;
  for (const PatternName& pattern : patternNames())
    known += (known.empty() ? "" : ", ") + std::string(pattern.name);
  throw InputError("--generate", "\"" + name + "\" is not one of " + known);
}

}  // namespace hogelscope
