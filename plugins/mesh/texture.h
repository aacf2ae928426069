// SPDX-License-Identifier: BSD-3-Clause
// An image on a surface: its mip chain in linear light, sampled bilinearly.
#pragma once

#include <cstdint>
#include <vector>

#include "picture.h"
#include "reading.h"
#include "srgb.h"

namespace hogelscope::mesh {

/// The continuation beyond the image: the image again, its border, or its mirror image.
enum class Wrap : std::uint8_t { repeat, clamp, mirror };

class Texture {
 public:
  /// Builds the mip chain. Throws if the listener cancels.
  Texture(const Picture& picture, const Reading& reading);

  /// Returns the light at u, v, from the image's top left corner to (1, 1) at the bottom right.
  /// Level 0 is the image, each further one has half its sides (box means); between two levels it
  /// returns their weighted mean.
  [[nodiscard]] Linear sample(double u, double v, double level, const Wrap wrap[2]) const;

  /// Returns the number of texels of level 0.
  [[nodiscard]] double size() const {
    return double(m_levels[0].width) * double(m_levels[0].height);
  }

 private:
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> texels;  ///< linear light, 0 … 65535, three values per texel

    [[nodiscard]] Linear sample(double u, double v, const Wrap wrap[2]) const;
  };

  static Level halved(const Level& level, const Reading& reading);

  std::vector<Level> m_levels;
};

}  // namespace hogelscope::mesh
