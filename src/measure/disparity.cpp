// SPDX-License-Identifier: BSD-3-Clause
#include "measure/disparity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

namespace {

constexpr int reach = 2;         ///< directions to each side
constexpr int window = 3;        ///< half the side of the square whose differences are summed
constexpr int mostPixels = 256;  ///< across or down a view: larger ones are scaled down
constexpr double step = 0.25;    ///< of the planes, pixels from view to view

/// One direction's view, scaled down; three values a pixel.
struct View {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
};

View viewOf(const LightField& texels, int u, int v, int scale) {
  const auto [nx, ny, du, dv] = texels.size();
  View view{nx / scale, ny / scale, {}};
  view.rgb.reserve(3 * std::size_t(view.width) * std::size_t(view.height));
  const double share = 1.0 / (scale * scale);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      Rgb sum;
      for (int j = y * scale; j < (y + 1) * scale; ++j)
        for (int i = x * scale; i < (x + 1) * scale; ++i) sum = sum + texels.texel({i, j, u, v});
      for (const double value : {sum.r, sum.g, sum.b}) view.rgb.push_back(float(share * value));
    }
  return view;
}

/// Adds the absolute differences of `reference` and a view that is moved by (x, y) pixels, with its
/// edges repeated and values between pixels interpolated.
void addDifferences(const View& reference, const View& view, double x, double y,
                    std::vector<float>& cost) {
  const int left = int(std::floor(x));
  const int top = int(std::floor(y));
  const auto right = float(x - left);
  const auto below = float(y - top);
  const auto pixel = [&](int column, int row) {
    return &view.rgb[3 *
                     (std::size_t(std::clamp(row, 0, view.height - 1)) * std::size_t(view.width) +
                      std::size_t(std::clamp(column, 0, view.width - 1)))];
  };
  std::size_t at = 0;
  for (int row = 0; row < view.height; ++row)
    for (int column = 0; column < view.width; ++column, ++at) {
      const float* const a = pixel(column + left, row + top);
      const float* const b = pixel(column + left + 1, row + top);
      const float* const c = pixel(column + left, row + top + 1);
      const float* const d = pixel(column + left + 1, row + top + 1);
      for (std::size_t k = 0; k < 3; ++k) {
        const float upper = a[k] + right * (b[k] - a[k]);
        const float lower = c[k] + right * (d[k] - c[k]);
        cost[at] += std::abs(upper + below * (lower - upper) - reference.rgb[3 * at + k]);
      }
    }
}

/// Replaces each value of a line by the mean over its window, with the edges repeated.
void blurLine(float* line, int count, std::size_t stride, std::vector<float>& copy) {
  copy.resize(std::size_t(count));
  for (int k = 0; k < count; ++k) copy[std::size_t(k)] = line[std::size_t(k) * stride];
  for (int k = 0; k < count; ++k) {
    float sum = 0;
    for (int o = -window; o <= window; ++o)
      sum += copy[std::size_t(std::clamp(k + o, 0, count - 1))];
    line[std::size_t(k) * stride] = sum / (2 * window + 1);
  }
}

void blur(std::vector<float>& cost, int width, int height) {
  std::vector<float> copy;
  for (int y = 0; y < height; ++y)
    blurLine(&cost[std::size_t(y) * std::size_t(width)], width, 1, copy);
  for (int x = 0; x < width; ++x) blurLine(&cost[std::size_t(x)], height, std::size_t(width), copy);
}

/// The other views of the sweep, and their steps from the direction.
struct Neighbour {
  View view;
  int u = 0;
  int v = 0;
};

/// Returns the plane, with a fraction, of least cost; NaN if no plane stands out.
double planeOf(std::vector<float> costs, std::size_t neighbours) {
  const auto least = std::ranges::min_element(costs);
  const auto plane = std::size_t(least - costs.begin());
  double fraction = 0;
  if (plane > 0 && plane + 1 < costs.size()) {
    const double before = costs[plane - 1];
    const double after = costs[plane + 1];
    const double bend = before + after - 2 * double(*least);
    if (bend > 0) fraction = 0.5 * (before - after) / bend;  // the parabola's lowest point
  }
  const double lowest = *least;
  const auto middle = costs.begin() + std::ptrdiff_t(costs.size() / 2);
  std::ranges::nth_element(costs, middle);
  // Code values summed over three channels: views of noise differ by less.
  const bool standsOut = lowest < 0.5 * double(*middle) && *middle > 4 * float(neighbours);
  return standsOut ? double(plane) + fraction : std::numeric_limits<double>::quiet_NaN();
}

Vec2 slopeSteps(const Display& display, const std::array<int, 2>& direction) {
  const auto [u, v] = direction;
  const Vec2 low = display.slopes(u, v + 1);
  const Vec2 high = display.slopes(u + 1, v);
  return {high.x - low.x, high.y - low.y};
}

/// The depth at which the shift −s z/p of views without a viewing distance would be that of z,
/// which may be −∞.
double parallelDepth(double z, double viewingDistance) {
  return viewingDistance == notGiven || z == 0 ? z : viewingDistance / (viewingDistance / z - 1);
}

/// The inverse of parallelDepth(); NaN for NaN, and for shifts beyond those of what is infinitely
/// far away.
double trueDepth(double parallel, double viewingDistance) {
  if (viewingDistance == notGiven) return parallel;
  const double sum = viewingDistance + parallel;
  return sum > 0 ? parallel * viewingDistance / sum : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::array<double, 2> disparityOf(double z, const PanelParams& display,
                                  const std::array<int, 2>& direction) {
  const Vec2 steps = slopeSteps(Display(display), direction);
  const double depth = parallelDepth(z, display.viewingDistance);
  return {-steps.x * depth * display.hogels[0] / display.size[0],
          -steps.y * depth * display.hogels[1] / display.size[1]};
}

HogelDepths depthsByDisparity(const LightFieldSource& lightField, const PanelParams& display,
                              const std::array<int, 2>& direction, const Progress& progress) {
  const LightFieldSize size = lightField.size();
  const auto [u0, v0] = direction;
  const auto around = [](int middle, int count) {
    return CellRange{std::max(middle - reach, 0), std::min(middle + reach, count - 1)};
  };
  const CellRange us = around(u0, size.du);
  const CellRange vs = around(v0, size.dv);
  if (us.first == us.last && vs.first == vs.last)
    throw InputError("lightField", "has one direction: its depths cannot be seen");
  const auto texels =
      lightField.slice(readsOfRows(size, {0, size.ny - 1}, us, vs), part(progress, 0, 0.3));
  HogelDepths result;
  result.scale = (std::max(size.nx, size.ny) + mostPixels - 1) / mostPixels;
  const View reference = viewOf(*texels, u0, v0, result.scale);
  result.width = reference.width;
  result.height = reference.height;
  std::vector<Neighbour> neighbours;
  for (int u = us.first; u <= us.last; ++u)
    if (u != u0) neighbours.push_back({viewOf(*texels, u, v0, result.scale), u - u0, 0});
  for (int v = vs.first; v <= vs.last; ++v)
    if (v != v0) neighbours.push_back({viewOf(*texels, u0, v, result.scale), 0, v - v0});

  // The planes: even in the shift of the axis that shifts more.
  const std::array<double, 2> perMetre = disparityOf(1, {display, notGiven}, direction);
  const double steepest =
      std::max(std::abs(size.du > 1 ? perMetre[0] : 0), std::abs(size.dv > 1 ? perMetre[1] : 0));
  const double farthest = std::max(4.0, std::max(reference.width, reference.height) / 40.0);
  const int planes = 2 * int(std::ceil(farthest / step)) + 1;
  const auto depthOf = [&](double plane) {
    return (plane - (planes - 1) / 2.0) * step * result.scale / steepest;
  };
  const std::size_t pixels = std::size_t(result.width) * std::size_t(result.height);
  const std::vector<float> none(pixels);
  std::vector costs(static_cast<std::size_t>(planes), none);
  const Progress swept = forThreads(part(progress, 0.3, 0.9));
  std::atomic<int> done = 0;
  parallelRows(planes, [&](int begin, int end) {
    for (int plane = begin; plane < end; ++plane) {
      std::vector<float>& cost = costs[std::size_t(plane)];
      const double pixelsPerView = depthOf(plane) / result.scale;
      for (const Neighbour& one : neighbours)
        addDifferences(reference, one.view, perMetre[0] * pixelsPerView * one.u,
                       perMetre[1] * pixelsPerView * one.v, cost);
      blur(cost, result.width, result.height);
      reportProgress(swept, double(++done) / planes);
    }
  });
  result.z.resize(pixels);
  parallelRows(result.height, [&](int begin, int end) {
    std::vector<float> ofPixel(costs.size());
    for (std::size_t at = std::size_t(begin) * std::size_t(result.width);
         at < std::size_t(end) * std::size_t(result.width); ++at) {
      for (std::size_t plane = 0; plane < costs.size(); ++plane) ofPixel[plane] = costs[plane][at];
      const double depth = depthOf(planeOf(ofPixel, neighbours.size()));
      const auto stays = [&](std::size_t place, int count, double perView) {
        const double shift = reach * std::abs(perView * depth) / result.scale;
        return double(place) - shift >= 0 && double(place) + shift <= count - 1;
      };
      const bool isInAll =
          stays(at % std::size_t(result.width), result.width, size.du > 1 ? perMetre[0] : 0) &&
          stays(at / std::size_t(result.width), result.height, size.dv > 1 ? perMetre[1] : 0);
      result.z[at] = isInAll ? trueDepth(depth, display.viewingDistance)
                             : std::numeric_limits<double>::quiet_NaN();
    }
  });
  return result;
}

}  // namespace hogelscope
