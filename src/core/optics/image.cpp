// SPDX-License-Identifier: BSD-3-Clause
// Images: rounding, and the image of a hogel.
#include "core/optics/image.h"

#include <cmath>

namespace hogelscope {

Image hogelErrorImage(const LightFieldSource& lightField, int i, int j) {
  const LightFieldSize size = lightField.size();
  Image image(size.du, size.dv);
  auto to = image.rgb.begin();
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const Rgb light = lightField.texel({i, j, u, v});
      for (const double value : {light.r, light.g, light.b}) *to++ = quantised(value);
    }
  }
  image.seen.assign(image.pixelCount(), 255);
  return image;
}

}  // namespace hogelscope
