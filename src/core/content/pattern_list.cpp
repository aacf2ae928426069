// SPDX-License-Identifier: BSD-3-Clause
#include "core/content/pattern_list.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/content/scene_pattern.h"
#include "core/content/sphere_pattern.h"

namespace hogelscope {

namespace {

constexpr int codeEnd = 4096;

void putCode(int a, int b, std::uint8_t* rgb) {
  rgb[0] = static_cast<std::uint8_t>(a % 256);
  rgb[1] = static_cast<std::uint8_t>(b % 256);
  rgb[2] = static_cast<std::uint8_t>(a / 256 + 16 * (b / 256));
}

using Made = std::unique_ptr<Pattern>;

template <CodePattern::Kind kind>
Made codes(const PanelParams& display, const PatternParams&) {
  return std::make_unique<CodePattern>(display, kind);
}

template <PlanePattern::Kind kind>
Made plane(const PanelParams& display, const PatternParams& params) {
  return std::make_unique<PlanePattern>(display, params, kind);
}

Made scene(const PanelParams& display, const PatternParams&) {
  return std::make_unique<ScenePattern>(display);
}

Made spheres(const PanelParams& display, const PatternParams& params) {
  return std::make_unique<SpherePattern>(display, params);
}

}  // namespace

void describe(ParameterVisitor& v, PatternParams& p) {
  auto& [depth, period, angle] = p;
  v.group("pattern", "Test content in closed form; no part of a session document.");
  v.field("depth", depth, {-10, 10, 0.01}, "m",
          "checkerboard, edge: distance of their plane in front of the panel; behind it below 0.");
  v.field("period", period, {1e-6, 10, 0.01}, "m",
          "checkerboard: side of two squares; spheres: of two squares of their planes.");
  v.field("angle", angle, {-89, 89, 1}, "°", "edge: angle from the vertical, to the left.");
}

CodePattern::CodePattern(const PanelParams& display, Kind kind)
    : m_size(Display(display).size()), m_kind(kind) {
  const bool isOfHogels = kind == hogels;
  const int largest = isOfHogels ? std::max(m_size.nx, m_size.ny) : std::max(m_size.du, m_size.dv);
  if (kind != sides && largest > codeEnd)
    throw InputError(isOfHogels ? "display.hogels" : "display.directions",
                     "are more than a code of 12 bits can tell: at most 4096 a side");
}

void CodePattern::row(int y, std::uint8_t* rgb) const {
  for (int i = 0; i < m_size.nx; ++i) {
    for (int u = 0; u < m_size.du; ++u, rgb += 3) {
      if (m_kind == sides) {
        const bool isLeft = 2 * u < m_size.du;
        rgb[0] = isLeft ? 255 : 0;
        rgb[1] = 0;
        rgb[2] = isLeft ? 0 : 255;
      } else if (m_kind == hogels) {
        putCode(i, y / m_size.dv, rgb);
      } else {
        putCode(u, y % m_size.dv, rgb);
      }
    }
  }
}

PlanePattern::PlanePattern(const PanelParams& display, const PatternParams& params, Kind kind)
    : m_display(display),
      m_params(params),
      m_kind(kind),
      m_normal{std::cos(radians(params.angle)), std::sin(radians(params.angle))} {}

std::uint8_t PlanePattern::value(double x, double y) const {
  if (m_kind == edge) return m_normal.x * x + m_normal.y * y < 0 ? 64 : 191;
  const double side = m_params.period / 2;
  const double parity = std::fmod(std::floor(x / side) + std::floor(y / side), 2);
  return parity == 0 ? 255 : 0;
}

void PlanePattern::row(int y, std::uint8_t* rgb) const {
  const LightFieldSize& size = m_display.size();
  for (int i = 0; i < size.nx; ++i) {
    for (int u = 0; u < size.du; ++u, rgb += 3) {
      const PanelRay ray = m_display.rayOf({i, y / size.dv, u, y % size.dv});
      std::fill_n(rgb, 3,
                  value(ray.position.x + m_params.depth * ray.slopes.x,
                        ray.position.y + m_params.depth * ray.slopes.y));
    }
  }
}

const std::vector<NamedPattern>& patterns() {
  static const std::vector<NamedPattern> list{
      {"scene", "lettering, ruler, ball and wall at known depths, smoothed", scene},
      {"spheres", "textured spheres and planes before and behind the panel; quick at any size",
       spheres},
      {"directions", "each pixel's colour tells its direction u, v",
       codes<CodePattern::directions>},
      {"hogels", "each pixel's colour tells its hogel i, j", codes<CodePattern::hogels>},
      {"checkerboard", "black and white squares on a plane at pattern.depth",
       plane<PlanePattern::checkerboard>},
      {"edge", "a slanted edge on a plane at pattern.depth", plane<PlanePattern::edge>},
      {"crosstalk", "light to the viewer's left is red, to the right blue",
       codes<CodePattern::sides>}};
  return list;
}

std::unique_ptr<Pattern> makePattern(const std::string& name, const PanelParams& display,
                                     const PatternParams& params) {
  if (display.hogels[0] < 1 || display.directions[0] < 1)
    throw InputError("display.hogels", "and directions are needed to make content");
  const auto& list = patterns();
  const auto found = std::ranges::find(list, name, &NamedPattern::name);
  if (found != list.end()) return found->make(display, params);
  std::string known;
  for (const NamedPattern& pattern : list)
    known += (known.empty() ? "" : ", ") + std::string(pattern.name);
  throw InputError("pattern", "\"" + name + "\"", "is not one of " + known);
}

}  // namespace hogelscope
