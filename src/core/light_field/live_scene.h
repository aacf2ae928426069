// SPDX-License-Identifier: BSD-3-Clause
// The interface of the 3-D scene that a live light field shows.
#pragma once

#include <array>
#include <span>

#include "core/base/geometry.h"
#include "core/light_field/texel.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

/// A ray of light in the display frame: its point on the panel (metres) and its slopes dx/dz, dy/dz
/// toward the viewer.
struct PanelRay {
  Vec2 position;
  Vec2 slopes;
};

/// What is wrong with "lightField.layout" where an ideal view is wanted of what is not live.
inline constexpr const char* noIdealView = "is not \"live\": only a 3-D scene has an ideal view";

/// The light and the depths of a scene along any rays, in the display frame, in metres. All
/// functions may be called from several threads at the same time, and throw InputError.
class LiveScene {
 public:
  virtual ~LiveScene() = default;

  /// Computes the light that an eye receives from the scene itself, without a display, along slopes
  /// dx/dz, dy/dz. The spans have one size.
  virtual void trace(const Vec3& eye, std::span<const Vec2> slopes, std::span<Rgb> light) const = 0;

  /// Computes the light along rays that leave the panel as texels' do.
  virtual void traceRays(std::span<const PanelRay> rays, std::span<Rgb> light) const = 0;

  /// Finds the depths z of what trace() sees; NaN for a ray that meets nothing. Content that does
  /// not know its depths is cut at ever more of them, and the depth is where the light becomes that
  /// of the whole content: to a thousandth of the content's range, and NaN where content has the
  /// background's colour.
  virtual void traceDepths(const Vec3& eye, std::span<const Vec2> slopes,
                           std::span<double> depths) const = 0;

  /// Returns the triangles that the window's 3-D scene draws, if there are any.
  [[nodiscard]] virtual plugin::Triangles triangles() const = 0;

  /// Returns the depths of what is traced of the content, the back one first.
  [[nodiscard]] virtual std::array<double, 2> depths() const = 0;

  /// Returns how many seconds its animation lasts, of which this is a moment; 0 if it does not
  /// move.
  [[nodiscard]] virtual double duration() const = 0;
};

}  // namespace hogelscope
