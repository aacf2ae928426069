// SPDX-License-Identifier: BSD-3-Clause
// The "scene" pattern: straight lines and lettering at known depths, which show distortion, leakage
// and parallax.
#include "core/content/scene_pattern.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/content/lattice.h"
#include "core/optics/image.h"

namespace hogelscope {

namespace {

// Lengths below are in half panel sides; z > 0 is in front of the panel.
constexpr double wallDepth = -0.5;
constexpr double rulerDepth = 0.25;
constexpr Vec3 ballCentre{-0.5, -0.4, 0.35};
constexpr double ballRadius = 0.22;

constexpr double everywhere = std::numeric_limits<double>::infinity();

constexpr Rgb ink{20, 20, 30};
constexpr Rgb paper{245, 243, 235};

constexpr std::string_view word = "HOGELSCOPE";
constexpr int glyphWidth = 5;
constexpr int glyphHeight = 7;

/// Returns a letter's rows from the top, the leftmost column in the highest of five bits.
constexpr std::array<unsigned char, glyphHeight> glyph(char letter) {
  switch (letter) {
    case 'H':
      return {0x11, 0x11, 0x11, 0x1F, 0x11, 0x11, 0x11};
    case 'O':
      return {0x0E, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0E};
    case 'G':
      return {0x0E, 0x11, 0x10, 0x17, 0x11, 0x11, 0x0F};
    case 'E':
      return {0x1F, 0x10, 0x10, 0x1E, 0x10, 0x10, 0x1F};
    case 'L':
      return {0x10, 0x10, 0x10, 0x10, 0x10, 0x10, 0x1F};
    case 'S':
      return {0x0F, 0x10, 0x10, 0x0E, 0x01, 0x01, 0x1E};
    case 'C':
      return {0x0E, 0x11, 0x10, 0x10, 0x10, 0x11, 0x0E};
    case 'P':
      return {0x1E, 0x11, 0x11, 0x1E, 0x10, 0x10, 0x10};
    default:
      return {};
  }
}

/// Whether (x, y) is on a letter of the word, written from the origin (its top left), x right, y
/// down, letters `height` tall.
bool onWord(double x, double y, double height) {
  const double cell = height / glyphHeight;
  const double column = std::floor(x / cell);
  const double row = std::floor(y / cell);
  constexpr int pitch = glyphWidth + 1;
  if (row < 0 || row >= glyphHeight || column < 0 || column >= pitch * double(word.size()))
    return false;
  const int letterColumn = int(column) % pitch;
  if (letterColumn >= glyphWidth) return false;
  const auto rows = glyph(word[std::size_t(int(column) / pitch)]);
  return (rows[std::size_t(row)] >> (glyphWidth - 1 - letterColumn) & 1) != 0;
}

bool nearLine(double x, double spacing, double width) {
  return std::abs(x - spacing * std::round(x / spacing)) < width / 2;
}

std::optional<ScenePattern::Met> ball(const Vec2& p, const Vec2& s) {
  // |(p + s z, z) - centre|² = radius², the root nearer to the viewer.
  const Vec3 d{s.x, s.y, 1};
  const Vec3 o = Vec3{p.x, p.y, 0} - ballCentre;
  const double half = dot(o, d) / dot(d, d);
  const double under = half * half - (dot(o, o) - ballRadius * ballRadius) / dot(d, d);
  if (under < 0) return std::nullopt;
  const double z = -half + std::sqrt(under);
  const Vec3 normal = (1 / ballRadius) * (o + z * d);
  const double shade = 0.25 + 0.75 * std::max(0.0, dot(normal, normalise({-0.5, 0.7, 0.5})));
  const bool stripe = std::fmod(std::floor(6 * (normal.y + 2)), 2) == 0;
  return ScenePattern::Met{shade * (stripe ? Rgb{235, 90, 40} : Rgb{250, 210, 60}), z};
}

/// Returns the ruler's colour: above the middle, a tick every 0.05, a long one every 0.25.
std::optional<Rgb> ruler(double x, double y) {
  if (std::abs(x) > 0.8 || y < 0.42 || y > 0.56) return std::nullopt;
  const bool tick = y > 0.5 && nearLine(x, 0.05, 0.018);
  const bool longTick = y > 0.46 && nearLine(x, 0.25, 0.03);
  return tick || longTick ? ink : Rgb{90, 190, 120};
}

/// Returns the colour of the card in the panel's plane, where lettering is sharpest.
std::optional<Rgb> card(double x, double y) {
  if (std::abs(x) > 0.86 || std::abs(y) > 0.13) return std::nullopt;
  return onWord(x + 0.8, 0.095 - y, 0.19) ? ink : paper;
}

/// Returns the wall's colour: ruled squares, with the word in ever smaller letters, as on an eye
/// chart.
Rgb wall(double x, double y) {
  double top = -0.3;
  for (const double height : {0.16, 0.12, 0.09, 0.065, 0.045}) {
    if (onWord(x + 0.3, top - y, height)) return ink;
    top -= 1.4 * height;
  }
  if (nearLine(x, 0.25, 0.022) || nearLine(y, 0.25, 0.022)) return {60, 80, 140};
  const bool dark = std::fmod(std::floor(4 * x) + std::floor(4 * y) + 1e3, 2) != 0;
  return dark ? Rgb{170, 195, 225} : Rgb{225, 235, 245};
}

}  // namespace

ScenePattern::ScenePattern(const PanelParams& display)
    : m_display(display),
      m_scale(std::min(display.size[0], display.size[1]) / 2),
      m_hogelPitch{display.size[0] / display.hogels[0], display.size[1] / display.hogels[1]} {}

std::optional<ScenePattern::Met> ScenePattern::light(const PanelRay& ray, double back,
                                                     double front) const {
  const Vec2 p{ray.position.x / m_scale, ray.position.y / m_scale};
  const Vec2& s = ray.slopes;
  const auto isBetween = [&](double z) { return back <= z * m_scale && z * m_scale <= front; };
  // The first content met from the viewer's side hides the rest.
  if (const auto met = ball(p, s); met && isBetween(met->z))
    return Met{met->light, met->z * m_scale};
  if (isBetween(rulerDepth))
    if (const auto colour = ruler(p.x + rulerDepth * s.x, p.y + rulerDepth * s.y))
      return Met{*colour, rulerDepth * m_scale};
  if (isBetween(0))
    if (const auto colour = card(p.x, p.y)) return Met{*colour, 0};
  if (!isBetween(wallDepth)) return std::nullopt;
  return Met{wall(p.x + wallDepth * s.x, p.y + wallDepth * s.y), wallDepth * m_scale};
}

std::array<double, 2> ScenePattern::depths() const {
  return {wallDepth * m_scale, (ballCentre.z + ballRadius) * m_scale};
}

Rgb ScenePattern::texel(const TexelIndex& at) const {
  // A rank-1 lattice over the hogel's area and the pixel's angle: all points differ in all four
  // coordinates.
  constexpr int points = 8;
  const PanelRay middle = m_display.rayOf(at);
  const PanelRay next = m_display.rayOf({at.i, at.j, at.u + 1, at.v + 1});
  const Vec2 slopeStep{next.slopes.x - middle.slopes.x, next.slopes.y - middle.slopes.y};
  Rgb sum;
  for (int k = 0; k < points; ++k) {
    const auto offset = [k](std::size_t axis) { return latticeOffset(k, points, axis); };
    const Vec2 aside{offset(0) * m_hogelPitch.x, offset(1) * m_hogelPitch.y};
    const Vec2 turn = m_display.turn(aside);
    const PanelRay ray{{middle.position.x + aside.x, middle.position.y + aside.y},
                       {middle.slopes.x + offset(2) * slopeStep.x - turn.x,
                        middle.slopes.y + offset(3) * slopeStep.y - turn.y}};
    sum = sum + light(ray, -everywhere, everywhere)->light;
  }
  return (1.0 / points) * sum;
}

void ScenePattern::row(int y, std::uint8_t* rgb) const {
  const LightFieldSize& size = m_display.size();
  for (int i = 0; i < size.nx; ++i) {
    for (int u = 0; u < size.du; ++u, rgb += 3) {
      const Rgb c = texel({i, y / size.dv, u, y % size.dv});
      rgb[0] = quantised(c.r);
      rgb[1] = quantised(c.g);
      rgb[2] = quantised(c.b);
    }
  }
}

}  // namespace hogelscope
