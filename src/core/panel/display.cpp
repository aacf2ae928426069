// SPDX-License-Identifier: BSD-3-Clause
// The display: the intersection of a ray with the panel, and the directional pixel seen there.
#include "core/panel/display.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace hogelscope {

namespace {

bool inside(double index, int count) {
  return index >= 0 && index < count;
}

}  // namespace

void describe(ParameterVisitor& v, DisplayParams& p) {
  auto& [position, orientation, size, hogels, directions, fov, lens, lensSource, lensParams,
         sheet] = p;
  v.group("display", "The panel: where it stands, its hogels and their directional pixels.");
  v.field("position", position, {-1e6, 1e6, 0.01}, "m", "The panel's centre in the world.");
  v.field("orientation", orientation, {-360, 360, 1}, "°",
          "Rotations about x, y, z, applied y first, then x, then z.");
  if (sheet) {
    describe(v, *sheet);
    v.count(hogels[0] > 0);
    v.field(
        {"hogels", "View size"}, hogels, {1, 65536, 1, true, 1, 1024}, "px",
        "Columns and rows of a live scene's views; otherwise the light field's file gives them.");
    v.field({"directions", "Views"}, directions, {1, 65536, 1, true, 1, 128}, "",
            "The number of a live scene's views, and 1.");
    return v.count(true);
  }
  v.field("size", size, {1e-6, 1e6, 0.01}, "m", "Width and height of the panel.");
  v.field("hogels", hogels, {1, 65536, 1, true, 1, 512}, "",
          "Columns and rows of hogels; may be left out if the light field's file gives them.");
  v.field("directions", directions, {1, 65536, 1, true, 1, 256}, "px",
          "Directional pixels of a hogel, across and down; may be left out as well.");
  v.field({"fov", "Field of view"}, fov, {0.01, 179.9, 1}, "°",
          "Full angles into which a hogel sends light, across and down.");
  v.field({"lens", "Hogel lens"}, lens, hogelLensNames(),
          "How a hogel's lens spreads its pixels: evenly in slope, evenly in angle, or as a plugin "
          "says.");
  if (lens == HogelLensModel::plugin)
    v.field({"lensSource", "Lens plugin"}, lensSource,
            "The plugin, such as \"measured-lens\"; its parameters are an object of that name.");
}

std::shared_ptr<const HogelLens> lensOf(const DisplayParams& params, std::size_t axis) {
  const double fov = params.fov.at(axis);
  return params.lens == HogelLensModel::plugin ? params.lensParams.lens(axis, fov)
                                               : makeHogelLens(params.lens, fov);
}

EyePlace eyePlaceOf(const DisplayParams& display, const Vec3& point) {
  const Vec3 p = transformFromPose(display.position, display.orientation).inverse().point(point);
  constexpr double degrees = 180 / std::numbers::pi;
  return {p, length(p), std::atan2(std::hypot(p.x, p.y), p.z) * degrees,
          std::atan2(p.x, p.z) * degrees};
}

bool hasDirections(const DisplayParams& display) {
  return !display.sheet;
}

Display::Display(const PanelParams& params, std::shared_ptr<const Twin> twin)
    : m_params(params),
      m_size{params.hogels[0], params.hogels[1], params.directions[0], params.directions[1]},
      m_displayFromWorld(transformFromPose(params.position, params.orientation).inverse()),
      m_lenses{lensOf(params, 0), lensOf(params, 1)},
      m_convergence(params.viewingDistance > 0 ? 1 / params.viewingDistance : 0),
      m_kind(kindOf(params, std::move(twin))) {
  if (m_kind) m_traits = m_kind->traits();
}

void Display::checkContent(const LightFieldSize& size) const {
  if (m_kind) m_kind->checkContent(size);
}

std::optional<Hit> Display::intersectPlane(const Vec3& eye, const Vec3& direction,
                                           std::size_t channel) const {
  if (m_traits.movesRays) return m_kind->meet(eye, direction, channel);
  if (!(eye.z > 0 && direction.z < 0)) return std::nullopt;
  const double a = direction.x / direction.z;
  const double b = direction.y / direction.z;
  const double x = eye.x - eye.z * a;
  const double y = eye.y - eye.z * b;
  return Hit{
      (x / m_params.size[0] + 0.5) * m_size.nx,
      (0.5 - y / m_params.size[1]) * m_size.ny,
      m_size.du * (0.5 + lens(0).directionOf(a + m_convergence * x)),
      m_size.dv * (0.5 - lens(1).directionOf(b + m_convergence * y)),
  };
}

/// A ray of slope a meets the panel at eye.x - eye.z·a, where its direction is that of the slope
/// a + convergence·(eye.x - eye.z·a).
PanelMap Display::mapFrom(const Vec3& eye) const {
  const auto [nx, ny, du, dv] = m_size;
  const auto& panel = m_params.size;
  const double turned = 1 - m_convergence * eye.z;
  PanelMap map;
  map.count = {nx, ny, du, dv};
  map.display = this;
  map.eye = eye;
  if (m_kind) m_kind->complete(map);
  map.constant = {(eye.x / panel[0] + 0.5) * nx, (0.5 - eye.y / panel[1]) * ny,
                  m_convergence * eye.x, m_convergence * eye.y};
  map.slope = {-eye.z / panel[0] * nx, eye.z / panel[1] * ny, turned, turned};
  if (!lens(0).isLinear() || !lens(1).isLinear()) return map;
  const double across = du / lens(0).slopeOf(1);
  const double down = dv / lens(1).slopeOf(1);
  map.constant[2] = 0.5 * du + across * map.constant[2];
  map.constant[3] = 0.5 * dv - down * map.constant[3];
  map.slope[2] *= across;
  map.slope[3] *= -down;
  return map;
}

bool Display::isOnPanel(const Hit& place) const {
  return inside(place.i, m_size.nx) && inside(place.j, m_size.ny);
}

bool Display::isInField(const Hit& place) const {
  return inside(place.u, m_size.du) && inside(place.v, m_size.dv);
}

std::optional<Hit> Display::hit(const Vec3& eye, const Vec3& direction, std::size_t channel) const {
  const std::optional<Hit> there = intersectPlane(eye, direction, channel);
  return there && isOnPanel(*there) && isInField(*there) ? there : std::nullopt;
}

Vec2 Display::slopes(double u, double v) const {
  return {lens(0).slopeOf(u / m_size.du - 0.5), lens(1).slopeOf(0.5 - v / m_size.dv)};
}

Vec2 Display::position(double i, double j) const {
  return {(i / m_size.nx - 0.5) * m_params.size[0], (0.5 - j / m_size.ny) * m_params.size[1]};
}

PanelRay Display::rayOf(const TexelIndex& at) const {
  if (m_kind)
    if (const std::optional<PanelRay> ray = m_kind->rayOf(at)) return *ray;
  const Vec2 place = position(at.i + 0.5, at.j + 0.5);
  const Vec2 middle = slopes(at.u + 0.5, at.v + 0.5);
  const Vec2 turned = turn(place);
  return {place, {middle.x - turned.x, middle.y - turned.y}};
}

}  // namespace hogelscope
