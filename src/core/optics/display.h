// SPDX-License-Identifier: BSD-3-Clause
// The display: a panel of hogels, each with a lens that sends every directional pixel its own way.
#pragma once

#include <array>
#include <optional>

#include "core/base/geometry.h"
#include "core/base/parameters.h"
#include "core/light_field/texel.h"
#include "core/optics/hogel_lens.h"

namespace hogelscope {

/// The session's `display`. Lengths in metres, angles in degrees.
struct DisplayParams {
  Vec3 position;
  Vec3 orientation;
  std::array<double, 2> size{0.5, 0.5};
  std::array<int, 2> hogels{0, 0};      ///< 0: as the light field's file says
  std::array<int, 2> directions{0, 0};  ///< 0: as the light field's file says
  std::array<double, 2> fov{60, 60};
  HogelLensModel lens = HogelLensModel::rectilinear;
  bool operator==(const DisplayParams&) const = default;
};

void describe(ParameterVisitor& v, DisplayParams& p);

/// A line that light takes in the display frame: where it meets the panel (metres) and its slopes
/// dx/dz, dy/dz toward the viewer.
struct PanelRay {
  Vec2 position;
  Vec2 slopes;
};

/// Where a ray meets the display, in real-valued indices: floor gives the hogel and direction.
struct Hit {
  double i = 0;
  double j = 0;
  double u = 0;
  double v = 0;
};

class Display {
 public:
  /// `params.hogels` and `params.directions` must be given.
  explicit Display(const DisplayParams& params);

  [[nodiscard]] const LightFieldSize& size() const { return m_size; }
  [[nodiscard]] const RigidTransform& displayFromWorld() const { return m_displayFromWorld; }
  /// Of the hogels, across (u) and down (v).
  [[nodiscard]] const HogelLens& lens(std::size_t axis) const { return *m_lenses[axis]; }

  /// The hit of a ray from an eye, both in the display frame (docs/formulas.md, Hit). None where
  /// the eye is not in front of the panel, the ray does not go toward it, misses it, or leaves the
  /// hogel's angular field.
  [[nodiscard]] std::optional<Hit> hit(const Vec3& eye, const Vec3& direction) const;

  /// The same where only the panel's plane matters: also beyond the panel and the angular field.
  /// None where the eye is not in front or the ray does not go toward the plane.
  [[nodiscard]] std::optional<Hit> intersectPlane(const Vec3& eye, const Vec3& direction) const;
  [[nodiscard]] bool isOnPanel(const Hit& place) const;
  [[nodiscard]] bool isInField(const Hit& place) const;

  /// Slopes dx/dz, dy/dz of the light of a real-valued direction: u = 0 … du, v = 0 … dv.
  [[nodiscard]] Vec2 slopes(double u, double v) const;
  /// A place on the panel, in its plane's metres: i = 0 … nx, j = 0 … ny.
  [[nodiscard]] Vec2 position(double i, double j) const;

  /// The ray that leaves the middle of a hogel through the middle of a directional pixel: the
  /// inverse of `hit`, for making content.
  [[nodiscard]] PanelRay rayOf(const TexelIndex& at) const;

 private:
  DisplayParams m_params;
  LightFieldSize m_size;
  RigidTransform m_displayFromWorld;
  std::array<std::shared_ptr<const HogelLens>, 2> m_lenses;
};

}  // namespace hogelscope
