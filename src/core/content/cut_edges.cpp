// SPDX-License-Identifier: BSD-3-Clause
#include "core/content/cut_edges.h"

#include <algorithm>
#include <array>
#include <vector>

namespace hogelscope {

namespace {

constexpr std::array<const char*, 4> edgeNames{"left", "right", "upper", "lower"};

/// Returns points of an edge, from end to end.
std::vector<Vec2> pointsOf(std::size_t edge, const PanelParams& display) {
  constexpr int most = 256;
  const bool isUpright = edge < 2;
  const double half = display.size[isUpright ? 0 : 1] / 2 * (edge == 0 || edge == 3 ? -1 : 1);
  const double along = display.size[isUpright ? 1 : 0];
  std::vector<Vec2> points;
  for (int k = 0; k < most; ++k) {
    const double place = along * ((k + 0.5) / most - 0.5);
    points.push_back(isUpright ? Vec2{half, place} : Vec2{place, half});
  }
  return points;
}

}  // namespace

std::string cutWarning(const plugin::ContentSource& content, const PanelParams& display,
                       const CameraState& state) {
  const Vec3 eye = Display(display).displayFromWorld().point(state.camera.eye);
  double back = 0;
  double front = 0;
  content.depths(back, front);
  // Content less than a hogel's width in front of the panel loses nothing that can be seen.
  const double nearest =
      std::max(display.size[0] / display.hogels[0], display.size[1] / display.hogels[1]);
  const double z = std::min(front + nearest, eye.z);
  if (!(z > nearest)) return {};
  std::string edges;
  for (std::size_t edge = 0; edge < edgeNames.size(); ++edge) {
    std::vector<plugin::Ray> rays;
    for (const Vec2& p : pointsOf(edge, display)) {
      const double a = (eye.x - p.x) / eye.z;
      const double b = (eye.y - p.y) / eye.z;
      rays.push_back({p.x + a * z, p.y + b * z, z, a, b, z});
    }
    std::vector<double> depths(rays.size());
    if (!content.traceDepths(rays, depths)) return {};
    if (std::ranges::any_of(depths, [&](double depth) { return depth > nearest; }))
      edges += (edges.empty() ? "" : ", ") + std::string(edgeNames[edge]);
  }
  if (edges.empty()) return {};
  return state.camera.name + ": the panel cuts what stands before it (" + edges +
         "): move the content back, or make it smaller";
}

}  // namespace hogelscope
