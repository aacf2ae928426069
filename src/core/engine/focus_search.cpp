// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/focus_search.h"

#include <algorithm>
#include <cmath>

#include "core/engine/fast_simulation.h"
#include "core/engine/ideal_view.h"

namespace hogelscope {

namespace {

/// Returns the way to a triangle along a ray, in lengths of `direction`; none if it does not meet
/// it (T. Möller and B. Trumbore, Journal of Graphics Tools 2, 1997).
std::optional<double> wayTo(const std::array<Vec3, 3>& corners, const Vec3& origin,
                            const Vec3& direction) {
  const Vec3 first = corners[1] - corners[0];
  const Vec3 second = corners[2] - corners[0];
  const Vec3 p = cross(direction, second);
  const double determinant = dot(first, p);
  if (determinant == 0) return std::nullopt;
  const Vec3 toOrigin = origin - corners[0];
  const double u = dot(toOrigin, p) / determinant;
  const Vec3 q = cross(toOrigin, first);
  const double v = dot(direction, q) / determinant;
  const double way = dot(second, q) / determinant;
  const bool meets = u >= 0 && v >= 0 && u + v <= 1 && way > 0;
  return meets ? std::optional(way) : std::nullopt;
}

/// Returns the depth along the axis of the first triangle that a pixel's ray meets.
std::optional<double> depthOf(const plugin::Triangles& scene, const RenderJob& job,
                              const Vec2& ideal) {
  const RigidTransform toDisplay =
      transformFromPose(job.display.position, job.display.orientation).inverse() *
      Camera(job.state.camera, job.state.intrinsics).worldFromCamera();
  const Vec3 direction = toDisplay.direction({ideal.x, ideal.y, 1});  // as long as to depth 1
  const auto point = [&](std::size_t corner) {
    const std::size_t at = 3 * std::size_t{scene.corners[corner]};
    return Vec3{scene.points[at], scene.points[at + 1], scene.points[at + 2]};
  };
  std::optional<double> nearest;
  for (std::size_t k = 0; k + 2 < scene.corners.size(); k += 3) {
    const auto way = wayTo({point(k), point(k + 1), point(k + 2)}, toDisplay.origin, direction);
    if (way && (!nearest || *way < *nearest)) nearest = way;
  }
  return nearest;
}

/// Returns the view of pixels [x - reach, x + reach] × [y - reach, y + reach] as far as they are in
/// the image.
RenderJob cropped(RenderJob job, int x, int y, int reach) {
  CameraState& state = job.state;
  const Camera camera(state.camera, state.intrinsics);
  const auto [width, height] = state.camera.res;
  const int left = std::max(x - reach, 0);
  const int top = std::max(y - reach, 0);
  state.camera.res = {std::min(x + reach + 1, width) - left, std::min(y + reach + 1, height) - top};
  state.intrinsics = {camera.focalLength().x, camera.focalLength().y, camera.centre().x - left,
                      camera.centre().y - top};
  return job;
}

/// Returns the standard deviation of the image's luminance, in linear light.
double contrastOf(const FloatImage& image) {
  double sum = 0;
  double squares = 0;
  const auto count = double(image.seen.size());
  for (std::size_t k = 0; k < image.seen.size(); ++k) {
    const auto at = [&](std::size_t c) { return linearFromEncoded(double(image.rgb[3 * k + c])); };
    const double light = luminance({at(0), at(1), at(2)});
    sum += light / count;
    squares += light * light / count;
  }
  return std::sqrt(std::max(0.0, squares - sum * sum));
}

FloatImage imageOf(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                   const Progress& progress) {
  if (job.isIdeal) return renderIdeal(job, tables, parallelRows, progress);
  const FastSimulation simulation(job, tables, parallelRows, progress);
  const auto [width, height] = job.state.camera.res;
  FloatImage image(width, height);
  simulation.rows(0, height, 0, width, image.rgb.data(), image.seen.data());
  return image;
}

/// Returns where the ideal camera has a pixel's ray; none if it has no ray.
std::optional<Vec2> rayOf(const RenderJob& job, int x, int y) {
  const Camera camera(job.state.camera, job.state.intrinsics);
  return idealPoint(Distortion(job.state.distortion), job.sampling.mapping,
                    camera.normalised(x, y));
}

constexpr int around = 7;  // pixels on each side of the picked one

/// Returns the place, -1 … 1, of the extremum of the parabola through three values at -1, 0, 1.
double extremum(double before, double middle, double after) {
  const double curvature = before - 2 * middle + after;
  return curvature < 0 ? std::clamp((before - after) / (2 * curvature), -1.0, 1.0) : 0;
}

/// Returns the place of the greatest of some contrasts, between two of them too; none if all are 0
/// or alike.
std::optional<double> placeOfGreatest(const std::vector<double>& contrasts) {
  const auto [least, best] = std::ranges::minmax_element(contrasts);
  if (!(*best > *least)) return std::nullopt;
  const auto at = double(best - contrasts.begin());
  if (best == contrasts.begin() || best == contrasts.end() - 1) return at;
  return at + extremum(*(best - 1), *best, *(best + 1));
}

}  // namespace

std::optional<double> sharpestFocus(const RenderJob& job, int x, int y, LensTables& tables,
                                    const ParallelRows& parallelRows, const Progress& progress) {
  checkContent(job);
  const std::optional<Vec2> ideal = rayOf(job, x, y);
  if (!ideal) return std::nullopt;
  const LiveScene* const scene = job.lightField->scene();
  const plugin::Triangles triangles = scene != nullptr ? scene->triangles() : plugin::Triangles();
  if (!triangles.corners.empty()) return depthOf(triangles, job, *ideal);
  constexpr int steps = 24;
  const double panel = axisDistance(job.state.camera, job.display);
  if (!(panel > 0)) return std::nullopt;
  RenderJob part = cropped(job, x, y, around);
  const auto dioptres = [panel](double step) { return std::lerp(2, 0.5, step / steps) / panel; };
  std::vector<double> contrasts;
  for (int step = 0; step <= steps; ++step) {
    throwIfCancelled(progress);
    part.state.pupil.focus = 1 / dioptres(step);
    contrasts.push_back(contrastOf(imageOf(part, tables, parallelRows, progress)));
  }
  const std::optional<double> best = placeOfGreatest(contrasts);
  return best ? std::optional(1 / dioptres(*best)) : std::nullopt;
}

std::optional<double> sharpestContent(
    const RenderJob& job, int x, int y, int count, const std::function<double(double k)>& at,
    const std::function<std::shared_ptr<const LightFieldSource>(double value)>& lightField,
    LensTables& tables, const ParallelRows& parallelRows, const Progress& progress) {
  if (!rayOf(job, x, y)) return std::nullopt;
  RenderJob part = cropped(job, x, y, around);
  part.isIdeal = true;
  part.state.pupil = {};
  std::vector<double> contrasts;
  for (int k = 0; k < count; ++k) {
    throwIfCancelled(progress);
    part.lightField = lightField(at(k));
    contrasts.push_back(contrastOf(imageOf(part, tables, parallelRows, progress)));
  }
  const std::optional<double> best = placeOfGreatest(contrasts);
  return best ? std::optional(at(*best)) : std::nullopt;
}

}  // namespace hogelscope
