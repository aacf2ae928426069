// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/pixel_inspection.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace hogelscope {

RayEnd endOf(const Display& display, const std::optional<Hit>& place) {
  if (!place || !display.isOnPanel(*place)) return RayEnd::misses;
  return display.isInField(*place) ? RayEnd::seen : RayEnd::outsideField;
}

std::string_view words(RayEnd end) {
  constexpr std::array<std::string_view, 4> texts{
      "no ray: the lens folds or ends before this pixel", "misses the panel",
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
  const Display display(job.display, job.twin);
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
  if (result.end == RayEnd::seen && hasDirections(job.display))
    result.taps = tapsAt(job.state.psf, display.size(), static_cast<int>(result.place->u),
                         static_cast<int>(result.place->v));
  return result;
}

PixelFate fateOf(const PixelTrace& trace) {
  if (!trace.colour) return trace.end == RayEnd::noRay ? PixelFate::noRay : PixelFate::outside;
  const auto [r, g, b] = *trace.colour;
  const bool isBlack = quantised(r) == 0 && quantised(g) == 0 && quantised(b) == 0;
  return isBlack ? PixelFate::dark : PixelFate::lit;
}

/// Uses the weights of Psf::leaked().
std::vector<double> psfKernelAt(const PsfParams& params, const LightFieldSize& size, int u, int v) {
  const Psf psf(params);
  const int reach = (params.windowSize - 1) / 2;
  const auto side = static_cast<std::size_t>(params.windowSize);
  std::vector<double> weights(side * side);
  double lost = 0;
  auto weight = psf.weights().begin();
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x, ++weight) {
      const int tapU = std::clamp(u + x, 0, size.du - 1);
      const int tapV = std::clamp(v + y, 0, size.dv - 1);
      const bool isInside = tapU == u + x && tapV == v + y;
      if (isInside || params.border == PsfBorder::clamp)
        weights[std::size_t(tapV - v + reach) * side + std::size_t(tapU - u + reach)] += *weight;
      else if (params.border == PsfBorder::black)
        lost += *weight;
    }
  const double total = std::accumulate(weights.begin(), weights.end(), lost);
  for (double& each : weights) each /= total;
  return weights;
}

Image hogelImage(const LightFieldSource& lightField, int i, int j) {
  const auto small = lightField.overview();
  const int smallI = i * small->size().nx / lightField.size().nx;
  const int smallJ = j * small->size().ny / lightField.size().ny;
  return hogelTexels(*small, smallI, smallJ);
}

}  // namespace hogelscope
