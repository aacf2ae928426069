// SPDX-License-Identifier: BSD-3-Clause
#include "core/content/capture_content.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

/// Two neighbouring cells, and the share of the second; an edge cell is repeated.
struct Neighbours {
  std::array<int, 2> cell{};
  double share = 0;
};

Neighbours neighboursOf(double place, int count) {
  const double middle = place - 0.5;
  const double first = std::floor(middle);
  const auto clamped = [count](double k) { return int(std::clamp(k, 0.0, count - 1.0)); };
  return {{clamped(first), clamped(first + 1)}, middle - first};
}

}  // namespace

void CaptureContent::describe(ParameterVisitor& v) {
  v.group("session", "A capture as a scene: the light field of another session, on any display.");
  v.field("file", m_file, "The session of the capture: its light field and its display.");
  v.field("position", m_position, {-1e6, 1e6, 0.01}, "m",
          "The middle of the capture's panel, in the display's frame.");
  v.field("orientation", m_orientation, {-360, 360, 1}, "°",
          "Its turns about x, then y, then z of the display's frame.");
  v.field("scale", m_scale, {1e-6, 1e6, 0.01, false, 0.1, 4}, "",
          "How many times its own size the capture's panel has, with all depths.");
  v.field("focus", m_focus, {-100, 100, 0.001, false, -0.5, 0.5}, "m",
          "The depth before the capture's panel that is sharp between its directions; in its own "
          "size.");
  v.field("interpolate", m_interpolates,
          "Interpolate between hogels and directions; otherwise the nearest ones, as they are.");
}

void CaptureContent::take(std::shared_ptr<const LightField> texels, const PanelParams& display,
                          std::vector<std::string> files) {
  m_texels = std::move(texels);
  m_display.emplace(display);
  m_files = std::move(files);
}

void CaptureContent::open(const plugin::Panel& panel, const plugin::Place& /*place*/,
                          const plugin::Progress& /*progress*/) {
  if (m_texels == nullptr) throw InputError("lightField.session", "has no capture");
  m_panel = transformFromPose(m_position, m_orientation);
  m_fromDisplay = m_panel.inverse();
  // Evenly spread rays stand for all: the powers of 1/g with g⁵ = g + 1 fill four axes.
  constexpr int count = 20000;
  constexpr double g = 1.1673039782614187, far = 1e6;
  int outside = 0;
  for (int k = 0; k < count; ++k) {
    std::array<double, 4> at{};
    double step = 1;
    for (double& each : at) each = std::fmod(0.5 + k * (step /= g), 1) - 0.5;
    const double a = at[0] * panel.directions[0] * panel.slopeStep[0];
    const double b = at[1] * panel.directions[1] * panel.slopeStep[1];
    const plugin::Ray ray{
        at[2] * panel.size[0] + a * far, at[3] * panel.size[1] + b * far, far, a, b, 2 * far};
    if (!meet(ray)) ++outside;
  }
  m_outside = double(outside) / count;
}

std::vector<std::string> CaptureContent::notes() const {
  const auto percent = std::lround(100 * m_outside);
  if (percent == 0) return {};
  const LightFieldSize& size = m_display->size();
  const Vec2 corner = m_display->position(size.nx, 0);
  const Vec2 most = m_display->slopes(size.du, 0);
  const auto degrees = [](double slope) {
    return numberText(fourDigits(2 * std::atan(slope) * 180 / std::acos(-1)));
  };
  return {"about " + std::to_string(percent) +
          " % of the display's rays are outside the capture, and black: it covers a panel of " +
          numberText(fourDigits(2 * m_scale * corner.x)) + "×" +
          numberText(fourDigits(2 * m_scale * corner.y)) + " m and a field of " + degrees(most.x) +
          "×" + degrees(most.y) + "°"};
}

void CaptureContent::depths(double& back, double& front) const {
  const LightFieldSize& size = m_display->size();
  back = std::numeric_limits<double>::infinity();
  front = -back;
  for (const int i : {0, size.nx})
    for (const int j : {0, size.ny}) {
      const Vec2 corner = m_display->position(i, j);
      const double z = m_panel.point({m_scale * corner.x, m_scale * corner.y, 0}).z;
      back = std::min(back, z);
      front = std::max(front, z);
    }
}

/// Returns the light of one direction between hogels; none beyond the panel.
Rgb CaptureContent::between(double i, double j, int u, int v) const {
  const LightFieldSize& size = m_display->size();
  if (!(i >= 0 && i < size.nx && j >= 0 && j < size.ny)) return {};
  const Neighbours across = neighboursOf(i, size.nx), down = neighboursOf(j, size.ny);
  Rgb sum;
  for (const std::size_t y : {0U, 1U})
    for (const std::size_t x : {0U, 1U}) {
      const double weight =
          (x == 1 ? across.share : 1 - across.share) * (y == 1 ? down.share : 1 - down.share);
      if (weight > 0) sum = sum + weight * m_texels->texel({across.cell[x], down.cell[y], u, v});
    }
  return sum;
}

/// A direction k contributes its light along the ray through the same point of the plane in focus:
/// it leaves the panel at (X − f s_k) / (1 − f/D), with X the ray's point of that plane.
Rgb CaptureContent::interpolated(const Hit& hit, const Vec2& place, const Vec2& slopes) const {
  const LightFieldSize& size = m_display->size();
  const Neighbours across = neighboursOf(hit.u, size.du), down = neighboursOf(hit.v, size.dv);
  const Vec2 least = m_display->position(0, 0), most = m_display->position(size.nx, size.ny);
  const double closer = 1 - m_focus * m_display->turn({1, 0}).x;
  const auto hogelOf = [](double at, double from, double to, int count) {
    return (at - from) / (to - from) * count;
  };
  Rgb sum;
  for (const std::size_t y : {0U, 1U})
    for (const std::size_t x : {0U, 1U}) {
      const double weight =
          (x == 1 ? across.share : 1 - across.share) * (y == 1 ? down.share : 1 - down.share);
      if (!(weight > 0)) continue;
      double i = hit.i, j = hit.j;
      if (m_focus != 0) {
        const Vec2 own = m_display->slopes(across.cell[x] + 0.5, down.cell[y] + 0.5);
        i = hogelOf((place.x + m_focus * (slopes.x - own.x)) / closer, least.x, most.x, size.nx);
        j = hogelOf((place.y + m_focus * (slopes.y - own.y)) / closer, least.y, most.y, size.ny);
      }
      sum = sum + weight * between(i, j, across.cell[x], down.cell[y]);
    }
  return sum;
}

/// Returns where a ray meets the panel within what was captured.
std::optional<CaptureContent::Met> CaptureContent::meet(const plugin::Ray& ray) const {
  const Vec3 from = m_fromDisplay.point({ray.x, ray.y, ray.z});
  const Vec3 along = m_fromDisplay.direction({ray.a, ray.b, 1});
  if (!(along.z > 0)) return {};  // the panel is seen from behind, or from its edge
  const double back = from.z / along.z;
  if (!(back >= 0 && back <= ray.reach)) return {};  // cut
  const Vec2 slopes{along.x / along.z, along.y / along.z};
  const Vec2 place{(from.x - slopes.x * from.z) / m_scale, (from.y - slopes.y * from.z) / m_scale};
  const auto hit =
      m_display->hit({place.x + slopes.x, place.y + slopes.y, 1}, {-slopes.x, -slopes.y, -1});
  if (!hit) return {};
  return Met{*hit, place, slopes};
}

Rgb CaptureContent::light(const plugin::Ray& ray) const {
  const std::optional<Met> met = meet(ray);
  if (!met) return {};
  const auto& [hit, place, slopes] = *met;
  if (m_interpolates) return interpolated(hit, place, slopes);
  return m_texels->texel({int(hit.i), int(hit.j), int(hit.u), int(hit.v)});
}

void CaptureContent::trace(std::span<const plugin::Ray> rays,
                           std::span<plugin::Colour> colours) const {
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto [r, g, b] = light(rays[k]);
    colours[k] = {float(r), float(g), float(b)};
  }
}

bool CaptureContent::traceDepths(std::span<const plugin::Ray> /*rays*/,
                                 std::span<double> depths) const {
  std::ranges::fill(depths, std::numeric_limits<double>::quiet_NaN());
  return true;
}

}  // namespace hogelscope
