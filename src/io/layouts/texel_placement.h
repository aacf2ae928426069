// SPDX-License-Identifier: BSD-3-Clause
// Shared by the readers of all layouts: pixels of images become texels.
#pragma once

#include <optional>
#include <string>

#include "core/light_field/light_field.h"
#include "io/images/image_file.h"

namespace hogelscope {

/// Advice for a light field that is too large.
inline constexpr const char* packIt = ": pack it into a store, and use that";

inline std::string pixels(std::size_t width, std::size_t height) {
  return std::to_string(width) + "×" + std::to_string(height);
}

/// Reads an image (ImageFile, or what reads alike) into the light field; `target(x, y)` returns the
/// texel of pixel (x, y), or none. `incoming` flips directions that were recorded looking into the
/// scene.
template <class Picture, class Target>
void readTexels(Picture& image, StoredType type, LightField& lightField, bool incoming,
                Target target, const Progress& progress) {
  const auto [nx, ny, du, dv] = lightField.size();
  const auto putRow = [&, du = du, dv = dv](int y, const auto* rgb) {
    for (int x = 0; x < int(image.width()); ++x, rgb += 3) {
      std::optional<TexelIndex> at = target(x, y);
      if (!at) continue;
      if (incoming) at = {at->i, at->j, du - 1 - at->u, dv - 1 - at->v};
      lightField.set(*at, rgb);
    }
  };
  image.read(
      type,
      [&](std::size_t first, std::size_t rows, const StoredRows& values) {
        std::visit(
            [&](const auto* rgb) {
              for (std::size_t row = 0; row < rows; ++row)
                putRow(int(first + row), rgb + 3 * row * image.width());
            },
            values);
      },
      progress);
}

}  // namespace hogelscope
