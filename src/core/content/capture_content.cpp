// SPDX-License-Identifier: BSD-3-Clause
#include "core/content/capture_content.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

/// Two neighbouring cells, and their shares; an edge cell is repeated.
struct Neighbours {
  std::array<int, 2> cell{};
  std::array<double, 2> share{};
};

/// `place` lies in [0, count).
Neighbours neighboursOf(double place, int count) {
  const int second = int(place + 0.5);
  const double share = place + 0.5 - second;
  return {{std::max(second - 1, 0), std::min(second, count - 1)}, {1 - share, share}};
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

void CaptureContent::take(std::shared_ptr<const LightFieldSource> capture,
                          const PanelParams& display, std::vector<std::string> files) {
  m_capture = std::move(capture);
  if (m_capture->isInMemory()) m_texels = m_capture->overview();
  m_display.emplace(display);
  const LightFieldSize& size = m_display->size();
  const Vec2 first = m_display->position(0, 0), second = m_display->position(1, 1);
  const double turn = m_display->turn({1, 0}).x;
  m_axes[0] = {size.nx, first.x, second.x - first.x, turn, {}};
  m_axes[1] = {size.ny, first.y, second.y - first.y, turn, {}};
  for (int u = 0; u < size.du; ++u) m_axes[0].slopes.push_back(m_display->slopes(u + 0.5, 0).x);
  for (int v = 0; v < size.dv; ++v) m_axes[1].slopes.push_back(m_display->slopes(0, v + 0.5).y);
  m_files = std::move(files);
}

std::shared_ptr<CaptureContent> CaptureContent::focusedAt(double focus) const {
  auto other = std::make_shared<CaptureContent>(*this);
  other->m_focus = focus;
  return other;
}

/// A point at depth z moves by z(Δs) over the panel from one direction to the next.
double CaptureContent::depthOfOneHogel() const {
  return (m_display->position(1, 0).x - m_display->position(0, 0).x) /
         (m_display->slopes(1, 0).x - m_display->slopes(0, 0).x);
}

void CaptureContent::open(const plugin::Panel& panel, const plugin::Place& /*place*/,
                          const plugin::Progress& /*progress*/) {
  if (m_capture == nullptr) throw InputError("lightField.session", "has no capture");
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

/// Returns along one axis what a ray takes of directions and hogels. `place` is the ray's point of
/// the panel, `slope` its slope. A direction k contributes its light along the ray through the same
/// point of the plane in focus: it leaves the panel at (X − f s_k) / (1 − f/D), with X the ray's
/// point of that plane.
CaptureContent::AxisTaps CaptureContent::tapsOf(const Axis& axis, double direction, double hogel,
                                                double place, double slope) const {
  AxisTaps taps;
  if (!m_interpolates) {
    taps.add({int(hogel), int(direction), 1});
    return taps;
  }
  const Neighbours directions = neighboursOf(direction, int(axis.slopes.size()));
  for (const std::size_t k : {0U, 1U}) {
    const int d = directions.cell[k];
    double at = hogel;
    if (m_focus != 0) {
      const double moved = place + m_focus * (slope - axis.slopes[std::size_t(d)]);
      at = (moved / (1 - m_focus * axis.turn) - axis.first) / axis.pitch;
    }
    if (!(at >= 0 && at < axis.hogels)) continue;  // beyond the panel
    const Neighbours hogels = neighboursOf(at, axis.hogels);
    for (const std::size_t h : {0U, 1U})
      if (const double weight = directions.share[k] * hogels.share[h]; weight > 0)
        taps.add({hogels.cell[h], d, weight});
  }
  return taps;
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
  return Met{tapsOf(m_axes[0], hit->u, hit->i, place.x, slopes.x),
             tapsOf(m_axes[1], hit->v, hit->j, place.y, slopes.y)};
}

void CaptureContent::traceIn(const LightField& texels, std::span<const plugin::Ray> rays,
                             std::span<plugin::Colour> colours) const {
  const BlockLayout& layout = texels.layout();
  const auto traceWith = [&]<class T>(const TexelArray<T>& list) {
    const auto unit = float(codeValue(T(1)));
    for (std::size_t k = 0; k < rays.size(); ++k) {
      std::array<float, 4> sum{};  // as a texel's four values, so that they are added at once
      if (const std::optional<Met> met = meet(rays[k]))
        for (const Tap& down : met->down.all()) {
          const std::uint32_t row =
              layout.j(std::uint32_t(down.hogel)) + layout.v(std::uint32_t(down.direction));
          for (const Tap& across : met->across.all()) {
            const auto stored =
                std::bit_cast<std::array<T, 4>>(list[row + layout.i(std::uint32_t(across.hogel)) +
                                                     layout.u(std::uint32_t(across.direction))]);
            const auto weight = float(across.weight * down.weight);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * float(stored[c]);
          }
        }
      colours[k] = {sum[0] * unit, sum[1] * unit, sum[2] * unit};
    }
  };
  std::visit(traceWith, texels.texels());
}

/// Traces with a slice of the capture. Rays that are too far from each other for one are halved.
void CaptureContent::traceSlices(std::span<const plugin::Ray> rays,
                                 std::span<plugin::Colour> colours) const {
  constexpr std::size_t mostOfSlice = std::size_t{1} << 19;  // of texels; such slices are not kept
  Footprint footprint(m_display->size().nx, m_display->size().ny);
  for (const plugin::Ray& ray : rays)
    if (const std::optional<Met> met = meet(ray)) {
      for (const auto& [hogel, direction, weight] : met->across.all())
        footprint.u[std::size_t(hogel)].include({direction, direction});
      for (const auto& [hogel, direction, weight] : met->down.all())
        footprint.v[std::size_t(hogel)].include({direction, direction});
    }
  if (rays.size() > 1 && footprint.texels() > mostOfSlice) {
    const std::size_t half = rays.size() / 2;
    traceSlices(rays.first(half), colours.first(half));
    traceSlices(rays.subspan(half), colours.subspan(half));
    return;
  }
  traceIn(*m_capture->slice({.footprint = [&] { return footprint; }, .mark = {}}, {}), rays,
          colours);
}

void CaptureContent::trace(std::span<const plugin::Ray> rays,
                           std::span<plugin::Colour> colours) const {
  if (m_texels != nullptr)
    traceIn(*m_texels, rays, colours);
  else
    traceSlices(rays, colours);
}

bool CaptureContent::traceDepths(std::span<const plugin::Ray> /*rays*/,
                                 std::span<double> depths) const {
  std::ranges::fill(depths, std::numeric_limits<double>::quiet_NaN());
  return true;
}

}  // namespace hogelscope
