// SPDX-License-Identifier: BSD-3-Clause
// The "scene" pattern: straight lines and lettering at known depths.
#pragma once

#include <array>
#include <optional>

#include "core/content/pattern.h"

namespace hogelscope {

/// A scene of the display's own size: a wall with a ruled grid and lettering behind the panel, a
/// lettered card in it, a ball and a ruler in front. Depths are proportional to the panel's smaller
/// side.
class ScenePattern : public Pattern {
 public:
  explicit ScenePattern(const PanelParams& display);

  void row(int y, std::uint8_t* rgb) const override;

  /// Returns the light of a directional pixel: the mean over its angle and its hogel's area.
  [[nodiscard]] Rgb texel(const TexelIndex& at) const;

  /// The first content that a line meets, from the viewer's side, between two depths, and its z in
  /// metres; the wall behind everything has no edges.
  struct Met {
    Rgb light;
    double z = 0;
  };
  [[nodiscard]] std::optional<Met> light(const PanelRay& ray, double back, double front) const;
  /// Returns the depths of the wall and of the ball's front.
  [[nodiscard]] std::array<double, 2> depths() const;

 private:
  Display m_display;
  double m_scale;  ///< half the panel's smaller side, metres
  Vec2 m_hogelPitch;
};

}  // namespace hogelscope
