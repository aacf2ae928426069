// SPDX-License-Identifier: BSD-3-Clause
// The "spheres" pattern, for light fields too large for a formula per pixel. In one row of a
// hogel's directions a sphere or a plane is one run of slopes, known in closed form; outside the
// runs the row is black.
#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "core/content/pattern.h"

namespace hogelscope {

class SpherePattern : public Pattern {
 public:
  SpherePattern(const PanelParams& display, const PatternParams& params);
  void row(int y, std::uint8_t* rgb) const override;

  /// Returns the colour of one pixel by tracing its ray, for tests.
  [[nodiscard]] std::array<std::uint8_t, 3> texel(const TexelIndex& at) const;

  /// A sphere in the display frame, in metres. Spheres do not touch the panel.
  struct Sphere {
    Vec3 centre;
    double radius;
    std::array<std::uint8_t, 3> colour;
  };
  struct Plane {
    Vec3 centre;
    Vec2 half;  ///< its extent to each side
    std::array<std::uint8_t, 3> colour;
  };

 private:
  struct Hogel;

  void draw(const Sphere& sphere, const Hogel& hogel, std::uint8_t* rgb) const;
  void draw(const Plane& plane, const Hogel& hogel, std::uint8_t* rgb) const;
  [[nodiscard]] std::array<int, 2> run(const Hogel& hogel, double from, double to) const;
  [[nodiscard]] std::array<std::uint8_t, 3> colourOf(const Sphere& sphere, const Vec3& origin,
                                                     const Vec2& slopes) const;
  [[nodiscard]] std::array<std::uint8_t, 3> colourOf(const Plane& plane, const Vec2& at) const;
  using Light = std::optional<std::array<std::uint8_t, 3>>;
  [[nodiscard]] Light lightOf(const Sphere& sphere, const Vec3& origin, const Vec2& slopes) const;
  [[nodiscard]] Light lightOf(const Plane& plane, const Vec3& origin, const Vec2& slopes) const;

  Display m_display;
  double m_square;                                    ///< side of a plane's squares
  std::vector<double> m_slopesX;                      ///< slope of each u, ascending
  std::vector<std::variant<Plane, Sphere>> m_things;  ///< later ones hide earlier ones
};

}  // namespace hogelscope
