// SPDX-License-Identifier: BSD-3-Clause
// Content of a live light field for tests: planes of constant depth with a formula each.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "core/content/live_source.h"

struct LivePlane {
  double z = 0;
  /// The light at (x, y), in code values; below 0: transparent.
  std::function<double(double x, double y)> light;
};

class LivePlanes : public hogelscope::plugin::ContentSource {
 public:
  /// Takes the planes from front to back.
  explicit LivePlanes(std::vector<LivePlane> planes) : m_planes(std::move(planes)) {}

  void describe(hogelscope::ParameterVisitor& v) override { v.group("planes", "Planes."); }
  void open(const hogelscope::plugin::Panel&, const hogelscope::plugin::Place&,
            const hogelscope::plugin::Progress&) override {}
  void depths(double& back, double& front) const override {
    back = m_planes.back().z;
    front = m_planes.front().z;
  }
  void trace(std::span<const hogelscope::plugin::Ray> rays,
             std::span<hogelscope::plugin::Colour> colours) const override {
    for (std::size_t k = 0; k < rays.size(); ++k) {
      colours[k] = {};
      for (const auto& [z, light] : m_planes) {
        const double t = rays[k].z - z;
        if (t < 0 || t > rays[k].reach) continue;
        const double value = light(rays[k].x - rays[k].a * t, rays[k].y - rays[k].b * t);
        if (value < 0) continue;
        colours[k] = {float(value), float(value), float(value)};
        break;
      }
    }
    traced += rays.size();
  }

  mutable std::atomic<std::size_t> traced = 0;

 private:
  std::vector<LivePlane> m_planes;
};

inline std::shared_ptr<hogelscope::LiveSource> liveSource(
    std::shared_ptr<const hogelscope::plugin::ContentSource> content,
    const hogelscope::PanelParams& display, const hogelscope::LiveParams& params = {},
    hogelscope::StoredType type = hogelscope::StoredType::real) {
  return std::make_shared<hogelscope::LiveSource>(std::move(content), display, params, type,
                                                  std::size_t{1} << 30, hogelscope::serialRows);
}
