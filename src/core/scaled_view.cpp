// SPDX-License-Identifier: BSD-3-Clause
// Pictures of fewer pixels, and their way back to full size.
#include "core/scaled_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hogelscope {

View reduced(const View& view) {
  View small = view;
  const int scale = std::exchange(small.method.scale, 1);
  if (scale == 1) return small;
  CameraState& state = small.state;
  const Camera camera(state.camera, state.intrinsics);
  for (int& pixels : state.camera.res) pixels = (pixels + scale - 1) / scale;
  const double middle = (scale - 1) / 2.0;
  state.intrinsics = {camera.focalLength().x / scale, camera.focalLength().y / scale,
                      (camera.centre().x - middle) / scale, (camera.centre().y - middle) / scale};
  return small;
}

namespace {

/// The two small pixels around each pixel of an axis, the second one's share, and the nearest.
struct Between {
  int first;
  int second;
  double share;
  int nearest;
};

std::vector<Between> between(int pixels, int smallPixels, int scale) {
  std::vector<Between> places;
  for (int x = 0; x < pixels; ++x) {
    const double at = (x - (scale - 1) / 2.0) / scale;
    const int left = static_cast<int>(std::floor(at));
    places.push_back({std::clamp(left, 0, smallPixels - 1),
                      std::clamp(left + 1, 0, smallPixels - 1), at - left, x / scale});
  }
  return places;
}

}  // namespace

Image enlarged(const Image& image, int scale, int width, int height) {
  Image full(width, height);
  const std::vector<Between> columns = between(width, image.width, scale);
  const std::vector<Between> rows = between(height, image.height, scale);
  const auto at = [&](int x, int y) {
    return std::size_t(y) * std::size_t(image.width) + std::size_t(x);
  };
  std::size_t to = 0;
  for (const Between& y : rows) {
    for (const Between& x : columns) {
      full.seen[to] = image.seen[at(x.nearest, y.nearest)];
      for (std::size_t c = 0; c < 3 && full.seen[to] != 0; ++c) {
        const auto value = [&](int column, int row) {
          return double(image.rgb[3 * at(column, row) + c]);
        };
        const double upper =
            (1 - x.share) * value(x.first, y.first) + x.share * value(x.second, y.first);
        const double lower =
            (1 - x.share) * value(x.first, y.second) + x.share * value(x.second, y.second);
        full.rgb[3 * to + c] = quantised((1 - y.share) * upper + y.share * lower);
      }
      ++to;
    }
  }
  return full;
}

}  // namespace hogelscope
