// SPDX-License-Identifier: BSD-3-Clause
#include "core/content/scene_content.h"

#include <limits>

namespace hogelscope {

void SceneContent::describe(ParameterVisitor& v) {
  v.group("scene",
          "The scene in closed form that \"generate scene\" writes; it has no parameters.");
}

void SceneContent::open(const plugin::Panel& panel, const plugin::Place& /*place*/,
                        const plugin::Progress& /*progress*/) {
  PanelParams display;
  display.size = {panel.size[0], panel.size[1]};
  display.hogels = {panel.hogels[0], panel.hogels[1]};
  display.directions = {panel.directions[0], panel.directions[1]};
  m_scene.emplace(display);
}

void SceneContent::depths(double& back, double& front) const {
  back = m_scene->depths()[0];
  front = m_scene->depths()[1];
}

std::optional<ScenePattern::Met> SceneContent::met(const plugin::Ray& ray) const {
  const auto& [x, y, z, a, b, reach] = ray;
  return m_scene->light({{x - a * z, y - b * z}, {a, b}}, z - reach, z);
}

void SceneContent::trace(std::span<const plugin::Ray> rays,
                         std::span<plugin::Colour> colours) const {
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto first = met(rays[k]);
    const Rgb light = first ? first->light : Rgb{};
    colours[k] = {float(light.r), float(light.g), float(light.b)};
  }
}

bool SceneContent::traceDepths(std::span<const plugin::Ray> rays, std::span<double> depths) const {
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto first = met(rays[k]);
    depths[k] = first ? first->z : std::numeric_limits<double>::quiet_NaN();
  }
  return true;
}

}  // namespace hogelscope
