// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/cameras/state_list_edits.h"
#include "io/scene/live_file.h"

namespace hogelscope {

namespace {

constexpr double panelSide = 0.5;  // the panel's longer one
constexpr double filled = 0.9;

/// The box around content, in the display frame.
struct Box {
  Vec3 least;
  Vec3 most;
};

Box boxAround(const std::vector<float>& points) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box{{far, far, far}, {-far, -far, -far}};
  for (std::size_t k = 0; k + 2 < points.size(); k += 3) {
    const Vec3 p{points[k], points[k + 1], points[k + 2]};
    box.least = {std::min(box.least.x, p.x), std::min(box.least.y, p.y),
                 std::min(box.least.z, p.z)};
    box.most = {std::max(box.most.x, p.x), std::max(box.most.y, p.y), std::max(box.most.z, p.z)};
  }
  return box;
}

/// Gives the panel a shape, with square hogels.
void shapePanel(DisplayParams& display, double width, double height) {
  constexpr int hogels = 256;  // along the longer side
  const double longer = std::max(width, height);
  const auto count = [&](double extent) {
    return std::max(1, int(std::lround(hogels * extent / longer)));
  };
  display.hogels = {count(width), count(height)};
  display.size = {panelSide * display.hogels[0] / hogels, panelSide * display.hogels[1] / hogels};
  display.directions = {100, 100};
  display.fov = {60, 60};
}

/// Returns the largest scale, at most `scale`, at which every point lies within the pyramid from
/// the eye over the panel, or nine tenths of it, where the front of the box stands at the depth
/// `front`. A point that is q behind the front and x beside the middle lies within it where s |x| ≤
/// h (1 − (front − s q) / D), with h nine tenths of half the panel and D the eye's distance.
double scaleWithin(const DisplayParams& display, const std::vector<float>& points, const Box& box,
                   double front, double scale) {
  const Vec3 middle = 0.5 * (box.least + box.most);
  const double distance = length(inFrontOf({display}).camera.eye - display.position);
  const auto limit = [&](double beside, double behind, double panel) {
    const double half = filled * panel / 2;
    const double growth = std::abs(beside) - half * behind / distance;
    if (growth > 0) scale = std::min(scale, half * (1 - front / distance) / growth);
  };
  for (std::size_t k = 0; k + 2 < points.size(); k += 3) {
    const double behind = box.most.z - points[k + 2];
    limit(points[k] - middle.x, behind, display.size[0]);
    limit(points[k + 1] - middle.y, behind, display.size[1]);
  }
  return scale;
}

}  // namespace

void fitMesh(LightFieldParams& params, DisplayParams& display, const Progress& progress) {
  shapePanel(display, 1, 1);
  params.content.set("position", std::vector<double>{0, 0, 0});
  constexpr float measuring = 0x1p-19F;  // near the least scale: large meshes are measured, too
  params.content.set("scale", std::vector<double>{measuring});
  std::vector<float> points = LiveFile(params, display, progress).content().triangles().points;
  for (float& value : points) value /= measuring;
  const Box box = boxAround(points);
  const Vec3 extent = box.most - box.least;
  const double longer = std::max(extent.x, extent.y);
  const Vec3 middle = 0.5 * (box.least + box.most);
  constexpr double mostSlender = 8;  // a line still gets some rows of hogels
  const double largest = filled * panelSide / longer;
  if (!(longer > 0) || largest < 1e-6 || largest > 1e6 || !(largest * length(middle) < 1000))
    throw InputError(contentName(params),
                     "is no mesh that a panel fits: it is too small, too large, or farther from "
                     "its origin than 2000 times its size");
  shapePanel(display, std::max(extent.x, longer / mostSlender),
             std::max(extent.y, longer / mostSlender));
  const double front = std::min(largest * extent.z / 4, panelSide / 10);
  const double fitted = fourDigits(scaleWithin(display, points, box, front, largest));
  params.content.set("scale", std::vector<double>{fitted});
  const auto tenths = [](double place) {
    return std::round(1e4 * place) / 1e4 + 0.0;  // of a millimetre; 0, not −0
  };
  params.content.set("position",
                     std::vector<double>{tenths(-fitted * middle.x), tenths(-fitted * middle.y),
                                         tenths(front - fitted * box.most.z)});
}

}  // namespace hogelscope
