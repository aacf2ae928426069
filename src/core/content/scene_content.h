// SPDX-License-Identifier: BSD-3-Clause
// The "scene" pattern as content of a live light field.
#pragma once

#include <optional>

#include "core/content/scene_pattern.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

class SceneContent : public plugin::ContentSource {
 public:
  void describe(ParameterVisitor& v) override;
  void open(const plugin::Panel& panel, const plugin::Place& place,
            const plugin::Progress& progress) override;
  void depths(double& back, double& front) const override;
  void trace(std::span<const plugin::Ray> rays, std::span<plugin::Colour> colours) const override;
  [[nodiscard]] bool traceDepths(std::span<const plugin::Ray> rays,
                                 std::span<double> depths) const override;

 private:
  [[nodiscard]] std::optional<ScenePattern::Met> met(const plugin::Ray& ray) const;

  std::optional<ScenePattern> m_scene;
};

}  // namespace hogelscope
