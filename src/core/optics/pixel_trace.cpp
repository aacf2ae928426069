// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/pixel_trace.h"

#include <array>
#include <cmath>

namespace hogelscope {

namespace {

RayEnd endOf(const Display& display, const std::optional<Hit>& place) {
  if (!place || !display.isOnPanel(*place)) return RayEnd::misses;
  return display.isInField(*place) ? RayEnd::seen : RayEnd::outsideField;
}

}  // namespace

std::string_view words(RayEnd end) {
  constexpr std::array<std::string_view, 4> texts{
      "no ray: the lens folds before this pixel", "misses the panel",
      "outside the hogel's angular field", "sees the display"};
  return texts.at(static_cast<std::size_t>(end));
}

PixelTrace pixelTrace(const RenderJob& job, int x, int y) {
  PixelTrace result;
  result.colour = Simulation(job).pixel(x, y);
  const Camera camera(job.state.camera, job.state.intrinsics);
  result.eye = job.state.camera.eye;
  const std::optional<Vec2> p =
      idealPoint(Distortion(job.state.distortion), job.sampling.mapping, camera.normalised(x, y));
  if (!p) {
    result.target = result.eye;
    return result;
  }
  const Display display(job.display);
  const Vec3 direction = camera.worldFromCamera().direction({p->x, p->y, 1});
  const Vec3 eye = display.displayFromWorld().point(result.eye);
  const Vec3 way = display.displayFromWorld().direction(direction);
  result.place = display.intersectPlane(eye, way);
  result.end = endOf(display, result.place);
  const double distance = length(job.state.camera.lookat - result.eye) / length(direction);
  result.target = result.eye + (result.place ? -eye.z / way.z : distance) * direction;
  if (!result.place) return result;
  result.position = display.position(result.place->i, result.place->j);
  result.slopes = {way.x / way.z, way.y / way.z};
  if (result.end == RayEnd::seen)
    result.taps = tapsAt(job.state.psf, display.size(), static_cast<int>(result.place->u),
                         static_cast<int>(result.place->v));
  return result;
}

}  // namespace hogelscope
