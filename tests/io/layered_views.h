// SPDX-License-Identifier: BSD-3-Clause
// Views of layers at known depths, for tests of the order of views with a known answer.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "capture/order/view_order.h"

/// A part of the scene with one parallax: an ellipse, or everything.
struct ViewLayer {
  double parallax = 0;  ///< pixels to the left (up) for each view to the right (down)
  double x = 0;         ///< the ellipse's centre in the middle view
  double y = 0;
  double width = 1e9;  ///< half axes
  double height = 1e9;
  int texture = 0;
  double opacity = 1;
  double period = 0;  ///< pixels; 0: the texture does not repeat
  double slope = 0;   ///< of the parallax, per image height downwards
};

struct ViewScene {
  std::vector<ViewLayer> layers;  ///< from back to front
  double contrast = 1;
  double noise = 0;    ///< code values, different for each view
  double flicker = 0;  ///< share of the brightness, different for each view
  int width = 240;
  int height = 180;
};

inline double hashOf(int a, int b, int c) {
  auto h = std::uint32_t(a) * 0x8DA6B343U + std::uint32_t(b) * 0xD8163841U +
           std::uint32_t(c) * 0xCB1AB31FU;
  h = (h ^ h >> 15U) * 0x2C1B3C6DU;
  h = (h ^ h >> 12U) * 0x297A2D39U;
  return double(h ^ h >> 15U) / 4294967295.0;
}

/// Returns value noise of one size, 0 … 1.
inline double noiseAt(double x, double y, int seed) {
  const double fx = std::floor(x);
  const double fy = std::floor(y);
  const auto ease = [](double t) { return t * t * (3 - 2 * t); };
  const double u = ease(x - fx);
  const double v = ease(y - fy);
  const auto at = [&](int i, int j) { return hashOf(int(fx) + i, int(fy) + j, seed); };
  return (at(0, 0) * (1 - u) + at(1, 0) * u) * (1 - v) + (at(0, 1) * (1 - u) + at(1, 1) * u) * v;
}

inline double textureAt(double x, double y, const ViewLayer& layer) {
  if (layer.period > 0) {
    constexpr double pi = 3.14159265358979;
    const double k = 2 * pi / layer.period;
    return 0.5 + 0.25 * (std::sin(k * x) + std::sin(k * y));
  }
  double sum = 0.35 * hashOf(layer.texture, 1, 2) - 0.17;
  double weight = 0.5;
  for (double size = 24; size > 3; size /= 2, weight *= 0.8)
    sum += 0.6 * weight * noiseAt(x / size, y / size, layer.texture * 7 + int(size));
  return sum;
}

/// Returns the view of a camera `u` views to the right and `v` views below the middle.
inline hogelscope::GreyPicture viewOf(const ViewScene& scene, double u, double v, int seed = 0) {
  hogelscope::GreyPicture picture{scene.width, scene.height, {}};
  std::mt19937 random{std::uint32_t(seed)};
  std::normal_distribution<double> noise(0, 1);
  const double gain = 1 + scene.flicker * (2 * hashOf(seed, 5, 9) - 1);
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      double value = 0;
      double light = 1;  // transmitted by the layers in front
      for (auto layer = scene.layers.rbegin(); layer != scene.layers.rend() && light > 0; ++layer) {
        const double parallax = layer->parallax + layer->slope * (double(y) / scene.height - 0.5);
        const double px = x + parallax * u;
        const double py = y + parallax * v;
        const double ex = (px - layer->x) / layer->width;
        const double ey = (py - layer->y) / layer->height;
        if (ex * ex + ey * ey > 1) continue;
        value += light * layer->opacity * textureAt(px, py, *layer);
        light *= 1 - layer->opacity;
      }
      value = 255 * gain * (0.5 + scene.contrast * (value - 0.5));
      if (scene.noise > 0) value += scene.noise * noise(random);
      picture.values.push_back(std::uint8_t(std::clamp(value, 0.0, 255.0) + 0.5));
    }
  return picture;
}

/// A symmetry of a grid: its axes reversed or exchanged in the files.
struct GridSymmetry {
  bool isUp = false;
  bool isLeft = false;
  bool isTransposed = false;
};

/// Returns rows × columns of cameras whose files are in another order.
inline hogelscope::GreyGrid gridOf(const ViewScene& scene, int rows, int columns,
                                   const GridSymmetry& symmetry = {}) {
  hogelscope::GreyGrid grid{
      symmetry.isTransposed ? columns : rows, symmetry.isTransposed ? rows : columns, {}};
  grid.view = [=](int row, int column) {
    if (symmetry.isTransposed) std::swap(row, column);
    if (symmetry.isUp) row = rows - 1 - row;
    if (symmetry.isLeft) column = columns - 1 - column;
    return viewOf(scene, column - (columns - 1) / 2.0, row - (rows - 1) / 2.0,
                  row * columns + column + 1);
  };
  return grid;
}

/// Returns blobs in front of a background, with parallaxes from `far` to `near`.
inline ViewScene randomScene(std::uint32_t seed, double far, double near) {
  std::mt19937 random{seed};
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  ViewScene scene;
  scene.layers.push_back({.parallax = far, .texture = int(seed) * 16});
  std::vector<double> parallaxes;
  for (int k = 0; k < 7; ++k) parallaxes.push_back(between(far + 0.2 * (near - far), near));
  std::sort(parallaxes.begin(), parallaxes.end());
  for (int k = 0; k < 7; ++k)
    scene.layers.push_back({.parallax = parallaxes[std::size_t(k)],
                            .x = between(0, scene.width),
                            .y = between(0, scene.height),
                            .width = between(15, 45),
                            .height = between(15, 45),
                            .texture = int(seed) * 16 + k + 1});
  return scene;
}
