// SPDX-License-Identifier: BSD-3-Clause
// Test content in closed form: the light of each directional pixel, for light fields of any size.
#pragma once

#include <string_view>
#include <vector>

#include "core/display.h"

namespace hogelscope {

/// A scene of the display's own size: a wall with a ruled grid and lettering behind the panel, a
/// lettered card in it, a ball and a bar in front. Depths are fractions of the panel's width.
class ScenePattern {
 public:
  explicit ScenePattern(const DisplayParams& display);

  /// The light of one directional pixel: the mean over its angle and its hogel's area.
  [[nodiscard]] Rgb texel(const TexelIndex& at) const;

 private:
  [[nodiscard]] Rgb light(const PanelRay& ray) const;

  Display m_display;
  double m_scale;  ///< half the panel's smaller side, metres
  Vec2 m_hogelPitch;
};

/// Names that `--generate` knows.
const std::vector<std::string_view>& patternNames();

}  // namespace hogelscope
