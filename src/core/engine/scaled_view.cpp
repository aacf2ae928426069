// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/scaled_view.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace hogelscope {

RenderJob reduced(const RenderJob& job) {
  RenderJob small = job;
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

CameraState resized(const CameraState& state, const std::array<int, 2>& res) {
  if (res == state.camera.res) return state;
  const Camera camera(state.camera, state.intrinsics);
  const double across = double(res[0]) / state.camera.res[0];
  const double down = double(res[1]) / state.camera.res[1];
  CameraState result = state;
  result.camera.res = res;
  // Pixel centres are at integers, so the border of the image is at -1/2.
  result.intrinsics = {across * camera.focalLength().x, down * camera.focalLength().y,
                       across * (camera.centre().x + 0.5) - 0.5,
                       down * (camera.centre().y + 0.5) - 0.5};
  return result;
}

RenderJob overview(const RenderJob& job) {
  if (job.lightField->isInMemory()) return job;
  RenderJob coarse = job;
  coarse.lightField = job.lightField->overview();
  const LightFieldSize size = coarse.lightField->size();
  coarse.display.hogels = {size.nx, size.ny};
  coarse.display.directions = {size.du, size.dv};
  coarse.state.psf.windowSize = 1;
  coarse.twin = nullptr;  // whose hogels and directions are all of the display's
  return coarse;
}

namespace {

/// The two small pixels around a pixel of an axis, and the second one's weight in units of
/// 1/(2·scale).
struct Between {
  int first;
  int second;
  int share;
};

Between between(int x, int smallPixels, int scale) {
  const int twice = 2 * x - (scale - 1);  // its position among the small ones, times 2·scale
  const int left = twice < 0 ? -1 : twice / (2 * scale);
  return {std::max(left, 0), std::min(left + 1, smallPixels - 1), twice - 2 * scale * left};
}

std::vector<Between> betweenAll(int pixels, int smallPixels, int scale) {
  std::vector<Between> all;
  all.reserve(std::size_t(pixels));
  for (int x = 0; x < pixels; ++x) all.push_back(between(x, smallPixels, scale));
  return all;
}

/// Divides a sum by 4·scale², rounded half up.
std::uint8_t share(std::uint8_t, int sum, int scale) {
  const int whole = 4 * scale * scale;
  const int shift = scale == 1 ? 2 : scale == 2 ? 4 : 6;
  return static_cast<std::uint8_t>((sum + whole / 2) >> shift);
}
float share(float, float sum, int scale) {
  return sum / static_cast<float>(4 * scale * scale);
}

/// Interpolates rows, then columns, in whole numbers, so that enlargedPixel() is equal.
template <class T>
std::vector<T> enlargedValues(const std::vector<T>& values, int scale,
                              const std::array<int, 2>& res) {
  using Sum = std::conditional_t<std::is_integral_v<T>, int, T>;
  const int smallWidth = (res[0] + scale - 1) / scale;
  const auto smallRow = 3 * std::size_t(smallWidth);
  const int smallHeight = int(values.size() / smallRow);
  const std::vector<Between> columns = betweenAll(res[0], smallWidth, scale);
  std::vector<T> full(3 * std::size_t(res[0]) * std::size_t(res[1]));
  std::vector<Sum> sums(smallRow);
  T* to = full.data();
  for (const Between& y : betweenAll(res[1], smallHeight, scale)) {
    const T* upper = &values[smallRow * std::size_t(y.first)];
    const T* lower = &values[smallRow * std::size_t(y.second)];
    const auto lowerShare = static_cast<Sum>(y.share);
    const auto upperShare = static_cast<Sum>(2 * scale - y.share);
    for (std::size_t k = 0; k < smallRow; ++k)
      sums[k] = upperShare * static_cast<Sum>(upper[k]) + lowerShare * static_cast<Sum>(lower[k]);
    for (const Between& x : columns) {
      const Sum* left = &sums[3 * std::size_t(x.first)];
      const Sum* right = &sums[3 * std::size_t(x.second)];
      const auto rightShare = static_cast<Sum>(x.share);
      const auto leftShare = static_cast<Sum>(2 * scale - x.share);
      for (int c = 0; c < 3; ++c)
        *to++ = share(T{}, leftShare * left[c] + rightShare * right[c], scale);
    }
  }
  return full;
}

/// Copies the mask of the nearest small pixel; pixels that are not seen become black.
template <class T>
std::vector<std::uint8_t> maskEnlarged(const std::vector<std::uint8_t>& small, int scale,
                                       const std::array<int, 2>& res, std::vector<T>& values) {
  const int shift = scale / 2;  // log2 of 1, 2 and 4
  const int smallWidth = (res[0] + scale - 1) / scale;
  std::vector<std::uint8_t> seen(values.size() / 3);
  std::size_t to = 0;
  for (int y = 0; y < res[1]; ++y) {
    const std::uint8_t* nearest = &small[std::size_t(y >> shift) * std::size_t(smallWidth)];
    for (int x = 0; x < res[0]; ++x, ++to) {
      seen[to] = nearest[x >> shift];
      if (seen[to] == 0) std::fill_n(&values[3 * to], 3, T{});
    }
  }
  return seen;
}

}  // namespace

Image enlarged(const Image& image, int scale, const std::array<int, 2>& res) {
  Image full(res[0], res[1]);
  full.rgb = enlargedValues(image.rgb, scale, res);
  full.seen = maskEnlarged(image.seen, scale, res, full.rgb);
  return full;
}

FloatImage enlarged(const FloatImage& image, int scale, const std::array<int, 2>& res) {
  FloatImage full(res[0], res[1]);
  full.rgb = enlargedValues(image.rgb, scale, res);
  full.seen = maskEnlarged(image.seen, scale, res, full.rgb);
  return full;
}

std::array<std::uint8_t, 3> enlargedPixel(const Image& image, int scale, int x, int y) {
  std::array<std::uint8_t, 3> rgb{};
  const auto width = std::size_t(image.width);
  if (image.seen[std::size_t(y / scale) * width + std::size_t(x / scale)] == 0) return rgb;
  const Between column = between(x, image.width, scale);
  const Between row = between(y, image.height, scale);
  const auto value = [&](int smallX, int smallY, std::size_t c) {
    return image.rgb[3 * std::size_t(smallY * image.width + smallX) + c];
  };
  const int whole = 2 * scale;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto down = [&](int smallX) {
      return (whole - row.share) * value(smallX, row.first, c) +
             row.share * value(smallX, row.second, c);
    };
    const int sum =
        (whole - column.share) * down(column.first) + column.share * down(column.second);
    rgb[c] = share(rgb[c], sum, scale);
  }
  return rgb;
}

}  // namespace hogelscope
