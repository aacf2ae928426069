// SPDX-License-Identifier: BSD-3-Clause
#include "core/content/pattern_list.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/content/plane_patterns.h"
#include "core/content/scene_pattern.h"
#include "core/content/sphere_pattern.h"

namespace hogelscope {

namespace {

using Made = std::unique_ptr<Pattern>;

template <CodePattern::Kind kind>
Made codes(const PanelParams& display, const PatternParams&) {
  return std::make_unique<CodePattern>(display, kind);
}

template <PlanePattern::Kind kind>
Made plane(const PanelParams& display, const PatternParams& params) {
  return std::make_unique<PlanePattern>(display, params, kind);
}

Made scene(const PanelParams& display, const PatternParams&) {
  return std::make_unique<ScenePattern>(display);
}

Made spheres(const PanelParams& display, const PatternParams& params) {
  return std::make_unique<SpherePattern>(display, params);
}

}  // namespace

const std::vector<NamedPattern>& patterns() {
  static const std::vector<NamedPattern> list{
      {"scene", "lettering, ruler, ball and wall at known depths, smoothed", scene},
      {"spheres", "textured spheres and planes before and behind the panel; quick at any size",
       spheres},
      {"directions", "each pixel's colour tells its direction u, v",
       codes<CodePattern::directions>},
      {"hogels", "each pixel's colour tells its hogel i, j", codes<CodePattern::hogels>},
      {"checkerboard", "black and white squares on a plane at pattern.depth",
       plane<PlanePattern::checkerboard>},
      {"edge", "a slanted edge on a plane at pattern.depth", plane<PlanePattern::edge>},
      {"crosstalk", "light to the viewer's left is red, to the right blue",
       codes<CodePattern::sides>}};
  return list;
}

std::unique_ptr<Pattern> makePattern(const std::string& name, const PanelParams& display,
                                     const PatternParams& params) {
  if (display.hogels[0] < 1 || display.directions[0] < 1)
    throw InputError("display.hogels", "and directions are needed to make content");
  const auto& list = patterns();
  const auto found = std::ranges::find(list, name, &NamedPattern::name);
  if (found != list.end()) return found->make(display, params);
  std::string known;
  for (const NamedPattern& pattern : list)
    known += (known.empty() ? "" : ", ") + std::string(pattern.name);
  throw InputError("pattern", "\"" + name + "\"", "is not one of " + known);
}

}  // namespace hogelscope
