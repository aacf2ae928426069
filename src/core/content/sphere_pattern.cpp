// SPDX-License-Identifier: BSD-3-Clause
#include "core/content/sphere_pattern.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

using Colour = std::array<std::uint8_t, 3>;

/// Shades a colour in a few steps of `share`, since runs of one colour compress.
Colour shaded(const Colour& colour, double share) {
  constexpr double steps = 5;
  const double step = std::ceil(std::clamp(share, 0.0, 1.0) * steps) / steps;
  Colour result{};
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = static_cast<std::uint8_t>(colour[k] * (0.3 + 0.7 * step));
  return result;
}

/// Returns the slopes a for which the line from `origin` with slopes (a, b) meets the sphere: those
/// between the roots of the discriminant of |origin + z (a, b, 1) − centre|² = radius².
std::optional<std::array<double, 2>> slopesThat(const SpherePattern::Sphere& sphere,
                                                const Vec3& origin, double b) {
  const Vec3 o = origin - sphere.centre;
  const double outside = dot(o, o) - sphere.radius * sphere.radius;
  const double m = o.y * b + o.z;
  const double square = o.x * o.x - outside;
  const double half = o.x * m;
  const double under = half * half - square * (m * m - outside * (b * b + 1));
  if (!(square < 0) || under < 0) return std::nullopt;  // no sphere touches the panel
  const double root = std::sqrt(under);
  return std::array{(-half + root) / square, (-half - root) / square};
}

}  // namespace

struct SpherePattern::Hogel {
  Vec3 origin;    ///< its middle
  double slopeY;  ///< the row's slope
  double turn;    ///< subtracted from slopes across, since hogels converge
};

SpherePattern::SpherePattern(const PanelParams& display, const PatternParams& params)
    : m_display(display), m_square(params.period / 2) {
  const double s = std::min(display.size[0], display.size[1]) / 2;
  m_things = {Plane{{-0.5 * s, 0.45 * s, -0.8 * s}, {0.35 * s, 0.25 * s}, {120, 170, 230}},
              Sphere{{0.5 * s, 0.4 * s, -0.6 * s}, 0.25 * s, {220, 80, 60}},
              Plane{{0.55 * s, -0.5 * s, -0.5 * s}, {0.3 * s, 0.3 * s}, {230, 200, 120}},
              Plane{{0, 0.75 * s, 0.15 * s}, {0.5 * s, 0.08 * s}, {90, 190, 120}},
              Sphere{{-0.45 * s, -0.45 * s, 0.35 * s}, 0.2 * s, {240, 160, 40}},
              Sphere{{0.1 * s, -0.05 * s, 0.6 * s}, 0.15 * s, {150, 110, 220}}};
  const LightFieldSize& size = m_display.size();
  for (int u = 0; u < size.du; ++u) m_slopesX.push_back(m_display.slopes(u + 0.5, 0).x);
}

/// Returns the range of u whose slopes are from `from` to `to` in a hogel.
std::array<int, 2> SpherePattern::run(const Hogel& hogel, double from, double to) const {
  const auto place = [&](double slope) {
    return int(std::lower_bound(m_slopesX.begin(), m_slopesX.end(), slope + hogel.turn) -
               m_slopesX.begin());
  };
  return {place(from), place(to)};
}

Colour SpherePattern::colourOf(const Sphere& sphere, const Vec3& origin, const Vec2& slopes) const {
  const Vec3 d{slopes.x, slopes.y, 1};
  const Vec3 o = origin - sphere.centre;
  const double half = dot(o, d) / dot(d, d);
  const double under = half * half - (dot(o, o) - sphere.radius * sphere.radius) / dot(d, d);
  const Vec3 normal = (1 / sphere.radius) * (o + (-half + std::sqrt(std::max(under, 0.0))) * d);
  const bool isStripe = std::fmod(std::floor(5 * (normal.y + 2)), 2) == 0;
  return shaded(isStripe ? Colour{245, 240, 230} : sphere.colour,
                dot(normal, normalise({-0.4, 0.6, 0.7})));
}

Colour SpherePattern::colourOf(const Plane& plane, const Vec2& at) const {
  const double parity = std::fmod(std::floor(at.x / m_square) + std::floor(at.y / m_square), 2);
  return parity == 0 ? plane.colour : shaded(plane.colour, 0.2);
}

void SpherePattern::draw(const Sphere& sphere, const Hogel& hogel, std::uint8_t* rgb) const {
  const auto slopes = slopesThat(sphere, hogel.origin, hogel.slopeY);
  if (!slopes) return;
  const auto [from, to] = run(hogel, (*slopes)[0], (*slopes)[1]);
  for (int u = from; u < to; ++u) {
    const Colour colour =
        colourOf(sphere, hogel.origin, {m_slopesX[std::size_t(u)] - hogel.turn, hogel.slopeY});
    std::copy_n(colour.begin(), 3, rgb + 3 * u);
  }
}

void SpherePattern::draw(const Plane& plane, const Hogel& hogel, std::uint8_t* rgb) const {
  const double z = plane.centre.z;
  const double y = hogel.origin.y + z * hogel.slopeY - plane.centre.y;
  if (std::abs(y) > plane.half.y) return;
  const auto slopeTo = [&](double x) { return (plane.centre.x + x - hogel.origin.x) / z; };
  const double left = slopeTo(-plane.half.x);
  const double right = slopeTo(plane.half.x);
  const auto [from, to] = run(hogel, std::min(left, right), std::max(left, right));
  for (int u = from; u < to; ++u) {
    const double x = hogel.origin.x + z * (m_slopesX[std::size_t(u)] - hogel.turn) - plane.centre.x;
    const Colour colour = colourOf(plane, {x, y});
    std::copy_n(colour.begin(), 3, rgb + 3 * u);
  }
}

void SpherePattern::row(int y, std::uint8_t* rgb) const {
  const LightFieldSize& size = m_display.size();
  std::fill_n(rgb, 3 * size.width(), std::uint8_t{0});
  for (int i = 0; i < size.nx; ++i, rgb += 3 * size.du) {
    const PanelRay ray = m_display.rayOf({i, y / size.dv, 0, y % size.dv});
    const Hogel hogel{
        {ray.position.x, ray.position.y, 0}, ray.slopes.y, m_display.turn(ray.position).x};
    for (const auto& thing : m_things)
      std::visit([&](const auto& one) { draw(one, hogel, rgb); }, thing);
  }
}

SpherePattern::Light SpherePattern::lightOf(const Sphere& sphere, const Vec3& origin,
                                            const Vec2& slopes) const {
  const Vec3 o = origin - sphere.centre;
  const double along = dot(o, normalise({slopes.x, slopes.y, 1}));
  if (dot(o, o) - along * along > sphere.radius * sphere.radius) return std::nullopt;
  return colourOf(sphere, origin, slopes);
}

SpherePattern::Light SpherePattern::lightOf(const Plane& plane, const Vec3& origin,
                                            const Vec2& slopes) const {
  const Vec2 at{origin.x + plane.centre.z * slopes.x - plane.centre.x,
                origin.y + plane.centre.z * slopes.y - plane.centre.y};
  if (std::abs(at.x) > plane.half.x || std::abs(at.y) > plane.half.y) return std::nullopt;
  return colourOf(plane, at);
}

Colour SpherePattern::texel(const TexelIndex& at) const {
  const PanelRay ray = m_display.rayOf(at);
  const Vec3 origin{ray.position.x, ray.position.y, 0};
  Colour colour{};
  for (const auto& thing : m_things) {
    const Light light =
        std::visit([&](const auto& one) { return lightOf(one, origin, ray.slopes); }, thing);
    colour = light.value_or(colour);
  }
  return colour;
}

}  // namespace hogelscope
