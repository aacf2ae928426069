// SPDX-License-Identifier: BSD-3-Clause
// A picture on a surface: its mip chain in linear light, read bilinearly.
#pragma once

#include <cstdint>
#include <vector>

#include "picture.h"
#include "reading.h"
#include "srgb.h"

namespace hogelscope::mesh {

/// What lies beside the picture: itself again, its border, its mirror image.
enum class Wrap : std::uint8_t { repeat, clamp, mirror };

class Texture {
 public:
  /// Throws where the listener stops.
  Texture(const Picture& picture, const Reading& reading);

  /// Returns the light at u, v, from the picture's top left corner to (1, 1) at the bottom right.
  /// Level 0 is the picture, each further one has half its sides (box means); between two levels
  /// their mean, weighted.
  [[nodiscard]] Linear sample(double u, double v, double level, const Wrap wrap[2]) const;

  /// The texels of level 0.
  [[nodiscard]] double size() const {
    return double(m_levels[0].width) * double(m_levels[0].height);
  }

 private:
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> texels;  ///< linear light, 0 … 65535, three for each texel

    [[nodiscard]] Linear sample(double u, double v, const Wrap wrap[2]) const;
  };

  static Level halved(const Level& level, const Reading& reading);

  std::vector<Level> m_levels;
};

}  // namespace hogelscope::mesh
